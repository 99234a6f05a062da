#pragma once
// Normals that vary smoothly over a mesh of flat triangles.

#include <array>
#include <span>
#include <vector>

#include "guides/mesh/triangle_mesh.h"

namespace lancret {

using CornerNormals = std::vector<std::array<Vec3f, 3>>;  ///< [triangles], unit

/// The normal at each corner: the mean over the triangles around its position, weighted
/// by their angles there, and limited to triangles within `crease` (radian) of the
/// corner's own, so that sharper edges remain. Corners at one position (to 2e-6 of the
/// mesh's size) belong together regardless of index, so seams do not show. The sign
/// follows the winding; zero for triangles without area. O(triangles): all are averaged
/// if more than 64 meet.
CornerNormals corner_normals(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                             const std::vector<Vec3f>& positions, float crease);

/// A point on a triangle, shaded as a point of the smooth surface.
struct SmoothPlace {
    Vec3f normal;  ///< unit
    Vec3f lift;  ///< cm, from the triangle to the smooth surface; zero if that lies below
};

/// The point `position`, of barycentrics `weights`, of a triangle with these corners and
/// normals, which are on the viewer's side. `face` is the flat normal and `viewer` the
/// direction to the viewer, both unit and on that side. A normal that faces away is
/// turned towards the viewer. The lift is half that of Hanika ["Hacking the Shadow
/// Terminator", Ray Tracing Gems II, 2021], the position of a surface of constant
/// curvature: a ray that starts there does not hit the facets that approximate it.
SmoothPlace smooth_place(const std::array<Vec3f, 3>& corners,
                         const std::array<Vec3f, 3>& normals, const Vec3f& weights,
                         const Vec3f& position, const Vec3f& face, const Vec3f& viewer);

}  // namespace lancret
