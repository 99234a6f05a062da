#include "render_test/trace/path_tracer.h"

#include <algorithm>
#include <cmath>

#include "render_test/light/light_choice.h"
#include "render_test/material/far_lobes.h"
#include "render_test/material/glossy.h"
#include "render_test/material/strand_section.h"
#include "render_test/sampling/sampling.h"
#include "render_test/trace/sample_pairs.h"

namespace lancret {
namespace {

/// Weights of light found by sampling lights and by scattering, each given the densities
/// of both ways.
float light_weight(LightSampling sampling, float light_pdf, float bsdf_pdf) {
    if (sampling == LightSampling::both) return mis_weight(light_pdf, bsdf_pdf);
    return sampling == LightSampling::lights ? 1.0f : 0.0f;
}
float scattering_weight(LightSampling sampling, float bsdf_pdf, float light_pdf) {
    if (sampling == LightSampling::both) return mis_weight(bsdf_pdf, light_pdf);
    return sampling == LightSampling::scattering ? 1.0f : 0.0f;
}

/// A path at a hit where it scatters.
struct ScatterPoint {
    const RenderScene& scene;
    const PathSettings& settings;
    const Hit& hit;
    int depth;  ///< scatterings before this one
    Sampler& sampler;
    Path& path;
};

/// Adds light that arrives directly from a light. `pick` and `random` are uniform.
template <class Bsdf>
void add_direct_light(const ScatterPoint& point, const Bsdf& bsdf, const Mat3f& frame,
                      float pick, const Vec2f& random) {
    Path& path = point.path;
    const LightSampling sampling = point.settings.sampling;
    const ChosenLight chosen = choose_light(
        point.scene.lights, point.hit.position, pick, random,
        [&](const LightSample& light) -> Vec3f {
            const BsdfValue at = bsdf.evaluate(frame.transpose() * light.direction);
            return path.throughput.cwiseProduct(at.value).cwiseProduct(light.radiance) *
                   (light_weight(sampling, light.pdf, at.pdf) / light.pdf);
        });
    if (!(chosen.contribution.maxCoeff() > 0)) return;
    Ray shadow = ray_from(point.hit, frame.col(2), chosen.light.direction, path.ray.time);
    shadow.far = chosen.light.distance * (1 - 1e-5f);
    if (!path.counter.occluded(shadow)) path.radiance += chosen.contribution;
}

/// One scattering: adds direct light and turns the path's ray. Returns whether the path
/// continues.
template <class Bsdf>
bool scatter_by(const Bsdf& bsdf, const Mat3f& frame, const ScatterPoint& point) {
    Sampler& sampler = point.sampler;
    Path& path = point.path;
    const Vec2f light_random = sampler.next(), picks = sampler.next();
    const Vec2f longitude = sampler.next(), azimuth = sampler.next();

    if (point.settings.sampling != LightSampling::scattering) {
        add_direct_light(point, bsdf, frame, picks.x(), light_random);
    }
    const std::optional<BsdfSample> sample =
        bsdf.sample(picks.y(), azimuth.x(), longitude);
    if (!sample) return false;
    path.throughput = path.throughput.cwiseProduct(sample->at.value) / sample->at.pdf;
    path.pdf = sample->at.pdf;
    path.ray = ray_from(point.hit, frame.col(2), (frame * sample->direction).normalized(),
                        path.ray.time);
    return path.throughput.maxCoeff() > 0;
}

/// Whether the strand at a hit scatters by the mean over its offset.
bool scatters_far(const ScatterPoint& point) {
    const Hit& hit = point.hit;
    // The tables are of round strands.
    if (hit.strand.section.aspect < 1) return false;
    if (point.settings.lobes != LobeWidth::automatic || point.depth > 0) {
        return point.settings.lobes != LobeWidth::near;
    }
    const float pixels =
        2 * hit.strand.radius / (hit.distance * point.settings.pixel_angle);
    if (!(pixels > 1 && pixels < 2)) return pixels <= 1;
    point.sampler.skip_to(kLobesPair);
    const float random = point.sampler.next().x();
    point.sampler.skip_to(kCameraPairs);
    return random < far_share(pixels);
}

bool scatter_on_strand(const ScatterPoint& point) {
    const RenderScene& scene = point.scene;
    const Hit& hit = point.hit;
    const StrandHit& strand = hit.strand;
    Mat3f frame;
    frame << hit.tangent, strand.facing.cross(hit.tangent), strand.facing;
    const HairLook& hair =
        point.depth > 0 && scene.later_hair ? *scene.later_hair : scene.hair;
    const HairModel& model = hair.model(strand.id);
    const Vec3f sigma_a = hair.sigma_a(strand.id, strand.along);
    const Vec3f wo = -point.path.ray.direction, local = frame.transpose() * wo;
    if (scatters_far(point)) {
        return scatter_by(FarHairBsdf(model, hair.far_table(strand.id), sigma_a, local),
                          frame, point);
    }
    return scatter_by(HairBsdf(model, sigma_a, local, strand.h, strand.section), frame,
                      point);
}

bool scatter(const ScatterPoint& point) {
    const RenderScene& scene = point.scene;
    const Hit& hit = point.hit;
    if (hit.kind == Hit::Kind::strand && !hit.strand.ribbon) {
        return scatter_on_strand(point);
    }
    const Mat3f frame = frame_about(hit.shading_normal);
    const Vec3f wo = -point.path.ray.direction, local = frame.transpose() * wo;
    if (hit.strand.ribbon) {
        const Blade blade(scene.blade, scene.hair.colour(hit.strand.id, hit.strand.along),
                          local);
        return scatter_by(blade, frame, point);
    }
    if (scene.mesh.coat_roughness) {
        return scatter_by(Glossy(scene.mesh, hit, local), frame, point);
    }
    return scatter_by(Lambert(scene.mesh, hit), frame, point);
}

}  // namespace

void follow_path(const RenderScene& scene, const PathSettings& settings, Hit hit,
                 Sampler& sampler, Path& path) {
    for (int depth = 0; depth < settings.max_depth; ++depth) {
        sampler.skip_to(kCameraPairs + kBouncePairs * std::uint32_t(depth));
        if (depth >= settings.roulette_depth) {
            const float survival = std::min(path.throughput.maxCoeff(), 0.98f);
            // The last pair of this bounce has a number to spare, but reading it here
            // would change the order of pairs: roulette has its own, far away.
            sampler.skip_to(kRoulettePair + std::uint32_t(depth));
            if (sampler.next().x() >= survival) return;
            path.throughput /= survival;
            sampler.skip_to(kCameraPairs + kBouncePairs * std::uint32_t(depth));
        }
        if (!scatter({scene, settings, hit, depth, sampler, path})) return;
        const std::optional<Hit> next = path.counter.intersect(path.ray);
        if (settings.sampling != LightSampling::lights) {
            path.radiance += path.throughput.cwiseProduct(scene.lights.along(
                path.ray.origin, path.ray.direction, next ? next->distance : path.ray.far,
                [&](float pdf) {
                    return scattering_weight(settings.sampling, path.pdf, pdf);
                }));
        }
        if (!next) return;
        hit = *next;
    }
}

float far_share(float pixels) {
    const float x = std::clamp(2 - pixels, 0.0f, 1.0f);
    return x * x * (3 - 2 * x);
}

}  // namespace lancret
