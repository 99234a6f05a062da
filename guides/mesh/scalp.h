#pragma once
// The surface that hair grows on.

#include <vector>

#include "guides/mesh/triangle_mesh.h"

namespace lancret {

/// A mesh with what evaluating it needs. Made by make_scalp and not changed after.
struct Scalp {
    TriangleMesh mesh;
    std::vector<Vec3> normals;  ///< [vertices], smooth, unit
    std::vector<double> areas;  ///< [triangles], cm^2
    double area = 0;            ///< cm^2, the sum of `areas`
};

/// The scalp of a mesh. A vertex's normal is the area-weighted mean of its triangles';
/// vertices at the same position share one, so that a seam in the UVs does not break the
/// surface. Where a mean vanishes the normal is +Z. Throws std::invalid_argument where an
/// index points nowhere or `uvs` is neither empty nor one a triangle.
Scalp make_scalp(TriangleMesh mesh);

/// The point's position, cm.
Vec3 scalp_position(const Scalp& scalp, const MeshPoint& point);

/// The smooth normal: vertex normals interpolated, unit length. Where they cancel, the
/// triangle's own; where that has none, +Z.
Vec3 scalp_normal(const Scalp& scalp, const MeshPoint& point);

/// The texture coordinates; (0, 0) where the mesh has none.
Vec2 scalp_uv(const Scalp& scalp, const MeshPoint& point);

/// The surface's own frame: columns [normal, tangent, normal x tangent], a rotation. The
/// tangent is dp/du made perpendicular to the smooth normal. Where the UVs are missing or
/// flat it is the triangle's first edge that is not along the normal, else any fixed
/// perpendicular: a triangle without area has a frame too. A frame's third column follows
/// from the other two, so mirrored UVs do not mirror it.
Mat3 surface_frame(const Scalp& scalp, const MeshPoint& point);

}  // namespace lancret
