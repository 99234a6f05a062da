#pragma once
// The rays of a path: counted, and started clear of the surface that they leave.

#include <cstdint>
#include <optional>
#include <vector>

#include "render_test/scene/embree_scene.h"

namespace lancret {

/// A ray as it was traced.
struct TracedRay {
    Ray ray;
    bool shadow;  ///< a query for any hit instead of the first
};

/// Traces rays and counts them.
struct RayCounter {
    const HairScene& geometry;
    std::vector<TracedRay>* record = nullptr;  ///< if set, receives every ray
    std::uint32_t rays = 0;                    ///< traced so far

    std::optional<Hit> intersect(const Ray& ray);
    bool occluded(const Ray& shadow);
};

/// A ray that leaves a hit. `side` is a unit normal: of a mesh, on the side that the ray
/// leaves to; of a ribbon, on either side.
Ray ray_from(const Hit& hit, const Vec3f& side, const Vec3f& direction, float time);

/// Distance from a strand's hit at which a ray in `direction` starts to count, cm. A flat
/// strand stands for a cylinder: scattering has already carried the ray through it, and
/// the strand must not be met again as it turns to face the new ray. The distance is that
/// at which the ray leaves the cylinder, limited to 21 radii for rays nearly along the
/// strand.
float strand_clearance(const Hit& hit, const Vec3f& direction);

}  // namespace lancret
