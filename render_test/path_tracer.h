#pragma once
// Light along one path: next-event estimation and sampling of the material, combined by
// multiple importance sampling [Veach 1997].

#include <cstdint>
#include <optional>
#include <vector>

#include "render_test/embree_scene.h"
#include "render_test/hair_bsdf.h"
#include "render_test/lambert.h"
#include "render_test/lights.h"
#include "render_test/sampler.h"

namespace lancret {

/// What light meets. The geometry must outlive it.
struct RenderScene {
    const HairScene* geometry = nullptr;
    HairModel hair{HairMaterial{}};
    /// Of every scattering after a path's first. Path regularisation: `widened` hair
    /// there leaves less noise and is a little brighter (docs/render_speed.md). None: as
    /// `hair`.
    std::optional<HairModel> later_hair;
    MeshMaterial mesh;
    Lights lights;
};

/// A ray as it was asked of the scene.
struct TracedRay {
    Ray ray;
    bool shadow;  ///< whether anything is met, and not what
};

struct PathSettings {
    int max_depth = 64;             ///< scatterings along a path; pale hair needs many
    int roulette_depth = 2;         ///< from here on, a path ends by chance
    bool show_environment = false;  ///< to the camera; then alpha is one everywhere
    std::vector<TracedRay>* record = nullptr;  ///< gets every ray; for one thread alone
};

struct PathResult {
    Vec3f radiance = Vec3f::Zero();
    std::optional<Hit> first;  ///< what the camera sees
    std::uint32_t rays = 0;    ///< traced, shadow rays too
};

/// Follows one path. Nothing is clamped: a sample may be far brighter than its pixel.
PathResult trace_path(const RenderScene& scene, const PathSettings& settings, Ray ray,
                      Sampler& sampler);

/// How far from a strand's hit a ray in `direction` starts to count, cm. Scattering has
/// already carried it through: a ribbon stands for a cylinder, and would otherwise be met
/// again as it turns to face the new ray. This is where the ray leaves the cylinder; of
/// rays nearly along the strand, at most 21 radii on.
float strand_clearance(const Hit& hit, const Vec3f& direction);

}  // namespace lancret
