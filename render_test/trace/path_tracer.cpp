#include "render_test/trace/path_tracer.h"

#include <algorithm>
#include <cmath>

#include "render_test/light/light_choice.h"
#include "render_test/material/glossy.h"
#include "render_test/material/strand_section.h"
#include "render_test/sampling/sampling.h"
#include "render_test/trace/check_view.h"
#include "render_test/trace/groom_shading.h"

namespace lancret {
namespace {

/// Pairs of random dimensions: two for place and time, then as many as this for each
/// bounce.
constexpr std::uint32_t kCameraPairs = 2, kBouncePairs = 4;

/// Far from all others: the choice among thin strands, and of lobes.
constexpr std::uint32_t kThinPair = 0x20000, kLobesPair = 0x40000;

/// A path on its way: what it has gathered, and what it still lets through.
struct Path {
    RayCounter counter;
    Ray ray;
    Vec3f radiance = Vec3f::Zero();
    Vec3f throughput = Vec3f::Ones();
    float pdf = 0;  ///< of the ray's direction, 1/sr

    std::optional<Hit> intersect() { return counter.intersect(ray); }
    bool occluded(const Ray& shadow) { return counter.occluded(shadow); }
};

/// Weight of a light found by sampling lights, and of one found by scattering, each with
/// the density of either way.
float light_weight(LightSampling sampling, float light_pdf, float bsdf_pdf) {
    if (sampling == LightSampling::both) return mis_weight(light_pdf, bsdf_pdf);
    return sampling == LightSampling::lights ? 1.0f : 0.0f;
}
float scattering_weight(LightSampling sampling, float bsdf_pdf, float light_pdf) {
    if (sampling == LightSampling::both) return mis_weight(bsdf_pdf, light_pdf);
    return sampling == LightSampling::scattering ? 1.0f : 0.0f;
}

/// Adds light that arrives at `hit` without a detour.
template <class Bsdf>
void add_direct_light(const RenderScene& scene, LightSampling sampling, const Hit& hit,
                      const Bsdf& bsdf, const Mat3f& frame, float pick,
                      const Vec2f& random, Path& path) {
    const ChosenLight chosen = choose_light(
        scene.lights, hit.position, pick, random, [&](const LightSample& light) -> Vec3f {
            const BsdfValue at = bsdf.evaluate(frame.transpose() * light.direction);
            return path.throughput.cwiseProduct(at.value).cwiseProduct(light.radiance) *
                   (light_weight(sampling, light.pdf, at.pdf) / light.pdf);
        });
    if (!(chosen.brings.maxCoeff() > 0)) return;
    Ray shadow = ray_from(hit, frame.col(2), chosen.light.direction, path.ray.time);
    shadow.far = chosen.light.distance * (1 - 1e-5f);
    if (!path.occluded(shadow)) path.radiance += chosen.brings;
}

/// One scattering at `hit`: adds light that arrives directly and turns the ray. False
/// where the path ends.
template <class Bsdf>
bool scatter(const RenderScene& scene, const PathSettings& settings, const Hit& hit,
             const Bsdf& bsdf, const Mat3f& frame, Sampler& sampler, Path& path) {
    const Vec2f light_random = sampler.next(), picks = sampler.next();
    const Vec2f longitude = sampler.next(), azimuth = sampler.next();

    if (settings.sampling != LightSampling::scattering)
        add_direct_light(scene, settings.sampling, hit, bsdf, frame, picks.x(),
                         light_random, path);
    const std::optional<BsdfSample> sample =
        bsdf.sample(picks.y(), azimuth.x(), longitude);
    if (!sample) return false;
    path.throughput = path.throughput.cwiseProduct(sample->at.value) / sample->at.pdf;
    path.pdf = sample->at.pdf;
    path.ray = ray_from(hit, frame.col(2), (frame * sample->direction).normalized(),
                        path.ray.time);
    return path.throughput.maxCoeff() > 0;
}

/// Whether the strand at `hit` scatters as its mean over the offset.
bool scatters_far(const PathSettings& settings, const Hit& hit, int depth,
                  Sampler& sampler) {
    // The tables are of round strands.
    if (hit.aspect < 1) return false;
    if (settings.lobes != LobeWidth::automatic || depth > 0)
        return settings.lobes != LobeWidth::near;
    const float pixels = 2 * hit.radius / (hit.distance * settings.pixel_angle);
    if (!(pixels > 1 && pixels < 2)) return pixels <= 1;
    sampler.skip_to(kLobesPair);
    const float random = sampler.next().x();
    sampler.skip_to(kCameraPairs);
    return random < far_share(pixels);
}

bool scatter(const RenderScene& scene, const PathSettings& settings, const Hit& hit,
             int depth, Sampler& sampler, Path& path) {
    const Vec3f wo = -path.ray.direction;
    Mat3f frame;
    if (hit.ribbon) {
        frame = frame_about(hit.shading_normal);
        const Blade blade(scene.blade, scene.hair.colour(hit.id, hit.along),
                          frame.transpose() * wo);
        return scatter(scene, settings, hit, blade, frame, sampler, path);
    }
    if (hit.kind == Hit::Kind::strand) {
        frame << hit.tangent, hit.facing.cross(hit.tangent), hit.facing;
        const HairLook& hair =
            depth > 0 && scene.later_hair ? *scene.later_hair : scene.hair;
        const HairModel& model = hair.model(hit.id);
        const Vec3f sigma_a = hair.sigma_a(hit.id, hit.along);
        const Vec3f local = frame.transpose() * wo;
        if (scatters_far(settings, hit, depth, sampler))
            return scatter(scene, settings, hit,
                           FarHairBsdf(model, hair.far_table(hit.id), sigma_a, local),
                           frame, sampler, path);
        return scatter(
            scene, settings, hit,
            HairBsdf(model, sigma_a, local, hit.h, {hit.aspect, hit.section_angle}),
            frame, sampler, path);
    }
    frame = frame_about(hit.shading_normal);
    if (scene.mesh.coat_roughness)
        return scatter(scene, settings, hit,
                       Glossy(scene.mesh, hit, frame.transpose() * wo), frame, sampler,
                       path);
    return scatter(scene, settings, hit, Lambert(scene.mesh, hit), frame, sampler, path);
}

/// What the camera sees: through strands that are thinner than they are drawn, on to the
/// first that is not or until no more than kMinLeft of the light is left. Of all that
/// it sees, `hit` is one, chosen by its share; `coverage` is the sum of the shares, and
/// so has no noise.
struct Seen {
    std::optional<Hit> hit;
    float coverage = 0;
};
constexpr float kMinLeft = 1e-3f;

Seen first_seen(RayCounter& counter, Ray ray, Sampler& sampler) {
    Seen seen;
    if (!counter.geometry.has_thin_strands()) {
        seen.hit = counter.intersect(ray);
        seen.coverage = seen.hit ? 1 : 0;
        return seen;
    }
    sampler.skip_to(kThinPair);
    float random = sampler.next().x(), left = 1;
    ray.by_chance = false;
    std::optional<Hit> last;
    while (const std::optional<Hit> hit = counter.intersect(ray)) {
        ray.near = hit->distance +
                   1e-6f * (1 + hit->position.cwiseAbs().maxCoeff() + hit->distance);
        // A segment's neighbour at their joint, or a tube's far side, is the same strand.
        if (last && hit->kind == Hit::Kind::strand && hit->strand == last->strand &&
            hit->distance - last->distance < strand_clearance(*last, ray.direction))
            continue;
        last = hit;
        float share = left * hit->opacity;
        if (left - share < kMinLeft) share = left;
        if (share > 0) {
            seen.coverage += share;
            const float chance = share / seen.coverage;
            if (!seen.hit || random < chance) {
                seen.hit = hit;
                random = std::min(random / chance, 1.0f);
            } else {
                random = (random - chance) / (1 - chance);
            }
        }
        left -= share;
        if (!(left > 0)) break;
    }
    return seen;
}

/// The path from what the camera sees until it ends.
void follow(const RenderScene& scene, const PathSettings& settings, Hit hit,
            Sampler& sampler, Path& path) {
    for (int depth = 0; depth < settings.max_depth; ++depth) {
        sampler.skip_to(kCameraPairs + kBouncePairs * std::uint32_t(depth));
        if (depth >= settings.roulette_depth) {
            const float survival = std::min(path.throughput.maxCoeff(), 0.98f);
            // The last pair of this bounce has a number to spare, but reading it here
            // would order the pairs otherwise: roulette has pairs of its own, far away.
            sampler.skip_to(0x10000u + std::uint32_t(depth));
            if (sampler.next().x() >= survival) return;
            path.throughput /= survival;
            sampler.skip_to(kCameraPairs + kBouncePairs * std::uint32_t(depth));
        }
        if (!scatter(scene, settings, hit, depth, sampler, path)) return;
        const std::optional<Hit> next = path.intersect();
        if (settings.sampling != LightSampling::lights)
            path.radiance += path.throughput.cwiseProduct(scene.lights.along(
                path.ray.origin, path.ray.direction, next ? next->distance : path.ray.far,
                [&](float pdf) {
                    return scattering_weight(settings.sampling, path.pdf, pdf);
                }));
        if (!next) return;
        hit = *next;
    }
}

}  // namespace

std::optional<Hit> RayCounter::intersect(const Ray& ray) {
    ++rays;
    if (record) record->push_back({ray, false});
    return geometry.intersect(ray);
}

bool RayCounter::occluded(const Ray& shadow) {
    ++rays;
    if (record) record->push_back({shadow, true});
    return geometry.occluded(shadow);
}

Ray ray_from(const Hit& hit, const Vec3f& side, const Vec3f& direction, float time) {
    Ray ray;
    ray.direction = direction;
    ray.time = time;
    const float rounding = 1e-5f * (1 + hit.position.cwiseAbs().maxCoeff());
    if (hit.ribbon) {
        // Embree finds a ribbon's surface to about a thousandth of its width.
        const float off = rounding + 2e-3f * hit.radius;
        ray.origin = hit.position + (direction.dot(side) < 0 ? -off : off) * side;
    } else if (hit.kind == Hit::Kind::strand) {
        ray.origin = hit.position;
        ray.near = strand_clearance(hit, direction) + 0.1f * rounding;
    } else {
        ray.origin = hit.position + hit.lift + rounding * side;
    }
    return ray;
}

float far_share(float pixels) {
    const float x = std::clamp(2 - pixels, 0.0f, 1.0f);
    return x * x * (3 - 2 * x);
}

float strand_clearance(const Hit& hit, const Vec3f& direction) {
    const Vec3f across = direction - hit.tangent * hit.tangent.dot(direction);
    const float cosine = std::max(across.norm(), 1e-6f);
    const float inward = hit.offset.dot(across) / cosine;
    const float r2 = hit.radius * hit.radius;
    const float leaves =
        std::sqrt(std::max(0.0f, inward * inward + r2 - hit.offset.squaredNorm())) -
        inward;
    return (1.01f * leaves + 0.02f * hit.radius) / std::max(cosine, 0.1f);
}

PathResult trace_path(const RenderScene& scene, const PathSettings& settings, Ray ray,
                      Sampler& sampler) {
    Path path{.counter = {*scene.geometry, settings.record}, .ray = ray};
    const Seen seen = first_seen(path.counter, ray, sampler);
    PathResult result;
    result.first = seen.hit;
    result.coverage = seen.coverage;
    path.throughput *= seen.coverage;
    if (settings.show_environment && seen.coverage < 1)
        path.radiance =
            (1 - seen.coverage) * scene.lights.environment().radiance(ray.direction);
    if (seen.hit && scene.view) {
        path.radiance +=
            seen.coverage * view_radiance(*scene.view, ray, *seen.hit, path.counter);
        result.value = view_value(*scene.view, *seen.hit);
    } else if (seen.hit && settings.groom_shading) {
        sampler.skip_to(kCameraPairs);
        path.radiance +=
            seen.coverage * groom_radiance(scene, ray, *seen.hit, sampler, path.counter);
    } else if (seen.hit) {
        follow(scene, settings, *seen.hit, sampler, path);
    }
    result.radiance = path.radiance;
    result.rays = path.counter.rays;
    return result;
}

}  // namespace lancret
