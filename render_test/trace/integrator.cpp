#include "render_test/trace/integrator.h"

#include <algorithm>

#include "render_test/trace/check_view.h"
#include "render_test/trace/groom_shading.h"
#include "render_test/trace/sample_pairs.h"

namespace lancret {
namespace {

/// What the camera sees along a ray. Strands that are thinner than drawn let it see on,
/// up to the first that is not thin or until at most kMinLeft of the light is left. `hit`
/// is one of all that it sees, chosen by share; `coverage` is the sum of the shares, and
/// so has no noise.
struct CameraHit {
    std::optional<Hit> hit;
    float coverage = 0;
};
constexpr float kMinLeft = 1e-3f;

CameraHit first_seen(RayCounter& counter, Ray ray, Sampler& sampler) {
    CameraHit seen;
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
        // The neighbour of a segment at their joint, or the far side of a tube, is the
        // same strand.
        if (last && hit->kind == Hit::Kind::strand &&
            hit->strand.index == last->strand.index &&
            hit->distance - last->distance < strand_clearance(*last, ray.direction)) {
            continue;
        }
        last = hit;
        float share = left * hit->strand.opacity;
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

}  // namespace

PathResult trace_path(const RenderScene& scene, const PathSettings& settings, Ray ray,
                      Sampler& sampler) {
    Path path{.counter = {*scene.geometry, settings.record}, .ray = ray};
    const CameraHit seen = first_seen(path.counter, ray, sampler);
    PathResult result;
    result.first = seen.hit;
    result.coverage = seen.coverage;
    path.throughput *= seen.coverage;
    if (settings.show_environment && seen.coverage < 1) {
        path.radiance =
            (1 - seen.coverage) * scene.lights.environment().radiance(ray.direction);
    }
    if (seen.hit && scene.view) {
        path.radiance +=
            seen.coverage * view_radiance(*scene.view, ray, *seen.hit, path.counter);
        result.value = view_value(*scene.view, *seen.hit);
    } else if (seen.hit && settings.groom_shading) {
        sampler.skip_to(kCameraPairs);
        path.radiance +=
            seen.coverage * groom_radiance(scene, ray, *seen.hit, sampler, path.counter);
    } else if (seen.hit) {
        follow_path(scene, settings, *seen.hit, sampler, path);
    }
    result.radiance = path.radiance;
    result.rays = path.counter.rays;
    return result;
}

}  // namespace lancret
