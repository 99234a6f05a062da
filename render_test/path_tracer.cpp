#include "render_test/path_tracer.h"

#include <algorithm>
#include <cmath>

#include "render_test/sampling.h"

namespace lancret {
namespace {

/// Pairs of random dimensions: two for place and time, then as many as this for each
/// bounce.
constexpr std::uint32_t kCameraPairs = 2, kBouncePairs = 4;

/// A path on its way: what it has gathered, and what it still lets through.
struct Path {
    const RenderScene& scene;
    std::vector<TracedRay>* record;
    Ray ray;
    Vec3f radiance = Vec3f::Zero();
    Vec3f throughput = Vec3f::Ones();
    float pdf = 0;  ///< of the ray's direction, 1/sr
    std::uint32_t rays = 0;

    std::optional<Hit> intersect() {
        ++rays;
        if (record) record->push_back({ray, false});
        return scene.geometry->intersect(ray);
    }
    bool occluded(const Ray& shadow) {
        ++rays;
        if (record) record->push_back({shadow, true});
        return scene.geometry->occluded(shadow);
    }
};

/// One scattering at `hit`: adds light that arrives directly and turns the ray. False
/// where the path ends.
template <class Bsdf>
bool scatter(const RenderScene& scene, const Hit& hit, const Bsdf& bsdf,
             const Mat3f& frame, Sampler& sampler, Path& path) {
    const auto start = [&](const Vec3f& direction) {
        Ray ray;
        ray.direction = direction;
        ray.time = path.ray.time;
        const float rounding = 1e-5f * (1 + hit.position.cwiseAbs().maxCoeff());
        if (hit.kind == Hit::Kind::strand) {
            ray.origin = hit.position;
            ray.near = strand_clearance(hit, direction) + 0.1f * rounding;
        } else {
            ray.origin = hit.position + rounding * frame.col(2);
        }
        return ray;
    };
    const Vec2f light_random = sampler.next(), picks = sampler.next();
    const Vec2f longitude = sampler.next(), azimuth = sampler.next();

    const LightSample light = scene.lights.sample(picks.x(), light_random);
    if (light.pdf > 0) {
        const BsdfValue at = bsdf.evaluate(frame.transpose() * light.direction);
        const Vec3f arrives = at.value.cwiseProduct(light.radiance);
        if (arrives.maxCoeff() > 0 && !path.occluded(start(light.direction)))
            path.radiance += path.throughput.cwiseProduct(arrives) *
                             (mis_weight(light.pdf, at.pdf) / light.pdf);
    }
    const std::optional<BsdfSample> sample =
        bsdf.sample(picks.y(), azimuth.x(), longitude);
    if (!sample) return false;
    path.throughput = path.throughput.cwiseProduct(sample->at.value) / sample->at.pdf;
    path.pdf = sample->at.pdf;
    path.ray = start((frame * sample->direction).normalized());
    return path.throughput.maxCoeff() > 0;
}

bool scatter(const RenderScene& scene, const Hit& hit, int depth, Sampler& sampler,
             Path& path) {
    const Vec3f wo = -path.ray.direction;
    Mat3f frame;
    if (hit.kind == Hit::Kind::strand) {
        frame << hit.tangent, hit.facing.cross(hit.tangent), hit.facing;
        const HairModel& hair =
            depth > 0 && scene.later_hair ? *scene.later_hair : scene.hair;
        const HairBsdf bsdf(hair, frame.transpose() * wo, hit.h);
        return scatter(scene, hit, bsdf, frame, sampler, path);
    }
    frame = frame_about(hit.normal.dot(wo) > 0 ? hit.normal : Vec3f(-hit.normal));
    return scatter(scene, hit, Lambert(scene.mesh, hit), frame, sampler, path);
}

}  // namespace

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
    PathResult result;
    Path path{.scene = scene, .record = settings.record, .ray = ray};
    for (int depth = 0;; ++depth) {
        const std::optional<Hit> hit = path.intersect();
        if (depth == 0) result.first = hit;
        if (!hit && depth == 0) {
            if (settings.show_environment)
                path.radiance = scene.lights.environment().radiance(path.ray.direction);
            break;
        }
        if (!hit) {
            const LightSample light = scene.lights.along(path.ray.direction);
            path.radiance += path.throughput.cwiseProduct(light.radiance) *
                             mis_weight(path.pdf, light.pdf);
            break;
        }
        if (depth == settings.max_depth) break;
        sampler.skip_to(kCameraPairs + kBouncePairs * std::uint32_t(depth));
        if (depth >= settings.roulette_depth) {
            const float survival = std::min(path.throughput.maxCoeff(), 0.98f);
            // The last pair of this bounce has a number to spare, but reading it here
            // would order the pairs otherwise: roulette has pairs of its own, far away.
            sampler.skip_to(0x10000u + std::uint32_t(depth));
            if (sampler.next().x() >= survival) break;
            path.throughput /= survival;
            sampler.skip_to(kCameraPairs + kBouncePairs * std::uint32_t(depth));
        }
        if (!scatter(scene, *hit, depth, sampler, path)) break;
    }
    result.radiance = path.radiance;
    result.rays = path.rays;
    return result;
}

}  // namespace lancret
