#pragma once
// Light along one path: next-event estimation and sampling of the material, combined by
// multiple importance sampling [Veach 1997].

#include <vector>

#include "guides/base/named.h"
#include "render_test/sampling/sampler.h"
#include "render_test/trace/rays.h"
#include "render_test/trace/render_scene.h"

namespace lancret {

/// How light is found. All converge to the same picture; `lights` and `scattering` exist
/// only for tests.
enum class LightSampling {
    both,        ///< the two below, combined by multiple importance sampling
    lights,      ///< by sampling lights only
    scattering,  ///< by sampling the material only
};

/// How a strand scatters: by the offset at which a ray meets it, which shows across a
/// strand that is many pixels wide, or by the mean over that offset, which has less
/// noise.
enum class LobeWidth {
    near,       ///< by offset (HairBsdf)
    far,        ///< the mean (FarHairBsdf)
    automatic,  ///< the mean for strands narrower than a pixel and for every scattering
                ///< after a path's first; by offset for strands wider than two pixels;
                ///< in between, one of the two at random
};

inline constexpr Named<LobeWidth> kLobeWidthNames[] = {
    {LobeWidth::near, "near"}, {LobeWidth::far, "far"}, {LobeWidth::automatic, "auto"}};

struct PathSettings {
    int max_depth = 64;             ///< scatterings along a path; pale hair needs many
    int roulette_depth = 2;         ///< Russian roulette from this scattering on
    bool show_environment = false;  ///< to the camera; alpha is then one everywhere
    std::vector<TracedRay>* record = nullptr;  ///< if set, receives every ray; for one
                                               ///< thread only
    LightSampling sampling = LightSampling::both;
    LobeWidth lobes = LobeWidth::near;
    float pixel_angle = 0;  ///< width of a pixel, radian; `automatic` compares strands
                            ///< with it, and `render` sets it
    bool groom_shading = false;  ///< replaces paths (groom_shading.h)
};

/// A path in progress.
struct Path {
    RayCounter counter;
    Ray ray;  ///< the last one traced, or the next
    Vec3f radiance = Vec3f::Zero();
    Vec3f throughput = Vec3f::Ones();
    float pdf = 0;  ///< of the ray's direction, 1/sr
};

/// Continues a path from `hit`, which its ray has met, until it ends.
void follow_path(const RenderScene& scene, const PathSettings& settings, Hit hit,
                 Sampler& sampler, Path& path);

/// Share of far-field lobes on a strand this many pixels wide if lobes are `automatic`:
/// one up to one pixel, falling smoothly to zero at two.
float far_share(float pixels);

}  // namespace lancret
