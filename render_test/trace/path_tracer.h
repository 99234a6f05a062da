#pragma once
// Light along one path: next-event estimation and sampling of the material, combined by
// multiple importance sampling [Veach 1997].

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "render_test/light/lights.h"
#include "render_test/material/blade.h"
#include "render_test/material/hair_look.h"
#include "render_test/material/lambert.h"
#include "render_test/sampling/sampler.h"
#include "render_test/scene/embree_scene.h"

namespace lancret {

struct CheckView;

/// What light meets. The geometry must outlive it.
struct RenderScene {
    const HairScene* geometry = nullptr;
    std::span<const SceneTime> times = {};  ///< that `geometry` was built of; for the
                                            ///< motion layer alone, else empty
    HairLook hair{HairMaterial{}};
    /// Of every scattering after a path's first. Path regularisation: wider hair there
    /// leaves less noise and is a little brighter (docs/render_speed.md). None: as
    /// `hair`.
    std::optional<HairLook> later_hair;
    MeshMaterial mesh;
    BladeMaterial blade;  ///< of ribbons
    Lights lights;
    const CheckView* view = nullptr;  ///< false colours in place of light; or none
};

/// A ray as it was asked of the scene.
struct TracedRay {
    Ray ray;
    bool shadow;  ///< whether anything is met, and not what
};

/// Asks rays of a scene and counts them.
struct RayCounter {
    const HairScene& geometry;
    std::vector<TracedRay>* record = nullptr;  ///< gets every ray, where given
    std::uint32_t rays = 0;                    ///< asked so far

    std::optional<Hit> intersect(const Ray& ray);
    bool occluded(const Ray& shadow);
};

/// Where light is looked for. Each gives the same picture at last: two of them alone are
/// there to prove it.
enum class LightSampling {
    both,        ///< combined by multiple importance sampling
    lights,      ///< towards lights alone
    scattering,  ///< where the material scatters alone
};

/// How a strand scatters: by the offset at which a ray meets it, which shows across a
/// strand of many pixels, or as its mean over that offset, with less noise.
enum class LobeWidth {
    near,       ///< by offset (HairBsdf)
    far,        ///< the mean (FarHairBsdf)
    automatic,  ///< the mean of strands narrower than a pixel, and wherever the camera
                ///< does not see the strand itself; by offset where they are wider
                ///< than two pixels; between, by chance
};

inline constexpr std::array<std::string_view, 3> kLobeWidthNames = {"near", "far",
                                                                    "auto"};

struct PathSettings {
    int max_depth = 64;             ///< scatterings along a path; pale hair needs many
    int roulette_depth = 2;         ///< from here on, a path ends by chance
    bool show_environment = false;  ///< to the camera; then alpha is one everywhere
    std::vector<TracedRay>* record = nullptr;  ///< gets every ray; for one thread alone
    LightSampling sampling = LightSampling::both;
    LobeWidth lobes = LobeWidth::near;
    float pixel_angle = 0;  ///< width of a pixel, radian: `automatic` compares strands
                            ///< with it; `render` sets it
    bool groom_shading = false;  ///< in place of paths (groom_shading.h)
};

struct PathResult {
    Vec3f radiance = Vec3f::Zero();
    std::optional<Hit> first;  ///< what the camera sees; one of what it sees through
    float coverage = 0;        ///< 0..1, less than one through thin strands
    std::uint32_t rays = 0;    ///< traced, shadow rays too
    float value = 0;           ///< of a check view, at `first`
};

/// Follows one path. Nothing is clamped: a sample may be far brighter than its pixel.
PathResult trace_path(const RenderScene& scene, const PathSettings& settings, Ray ray,
                      Sampler& sampler);

/// A ray from a hit; `side` is the unit normal of a mesh on the side that it leaves to,
/// of a ribbon on either.
Ray ray_from(const Hit& hit, const Vec3f& side, const Vec3f& direction, float time);

/// The share of far-field lobes on strands so many pixels wide, where lobes are
/// automatic: one up to one pixel, falling smoothly to none at two.
float far_share(float pixels);

/// How far from a strand's hit a ray in `direction` starts to count, cm. Scattering has
/// already carried it through: a ribbon stands for a cylinder, and would otherwise be met
/// again as it turns to face the new ray. This is where the ray leaves the cylinder; of
/// rays nearly along the strand, at most 21 radii on.
float strand_clearance(const Hit& hit, const Vec3f& direction);

}  // namespace lancret
