#pragma once
// Normals that vary smoothly over a mesh of flat triangles.

#include <array>
#include <span>
#include <vector>

#include "guides/mesh/triangle_mesh.h"

namespace lancret {

using CornerNormals = std::vector<std::array<Vec3f, 3>>;  ///< [triangles], unit

/// The normal at each corner: the mean of those of the triangles round its place, each by
/// its angle there, of those that lie within `crease` (radian) of the corner's own, so
/// that an edge that is sharper stays an edge. Corners at one place belong together
/// whatever their index (to 2e-6 of the mesh's size): a seam does not show. The sign is
/// that of the winding; of a triangle without area they are zero. O(triangles): beyond 64
/// triangles round a place all of them count.
CornerNormals corner_normals(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                             const std::vector<Vec3f>& positions, float crease);

/// A place on a triangle as light is to see it.
struct SmoothPlace {
    Vec3f normal;  ///< unit
    Vec3f lift;    ///< cm, from the triangle to the curved surface that it stands for, or
                   ///< zero where that lies below
};

/// The place `position` of a triangle with these corners, its barycentrics `weights` and
/// normals on the side that it is seen from. `face` is the flat normal, `viewer` the
/// direction back, both unit and on that side too; the normal is turned towards the
/// viewer as far as it faces away. The lift is half that of Hanika ["Hacking the Shadow
/// Terminator", Ray Tracing Gems II, 2021], which is
/// where a surface of even curvature lies: a ray that starts there does not meet the
/// facets that the smooth surface does not have.
SmoothPlace smooth_place(const std::array<Vec3f, 3>& corners,
                         const std::array<Vec3f, 3>& normals, const Vec3f& weights,
                         const Vec3f& position, const Vec3f& face, const Vec3f& viewer);

}  // namespace lancret
