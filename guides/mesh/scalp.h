#pragma once
// The surface that hair grows on.

#include <vector>

#include "guides/mesh/triangle_mesh.h"

namespace lancret {

/// A mesh with its normals and areas. Made by make_scalp and not modified afterwards.
struct Scalp {
    TriangleMesh mesh;
    std::vector<Vec3> normals;  ///< [vertices], smooth, unit
    std::vector<double> areas;  ///< [triangles], cm^2
    double area = 0;            ///< cm^2, the sum of `areas`
};

/// The scalp of a mesh. A vertex's normal is the area-weighted mean of its triangles';
/// vertices at the same position share one, so that a seam in the UVs does not break the
/// surface. If the mean is zero, the normal is +Z. Throws std::invalid_argument if an
/// index is out of range or `uvs` is neither empty nor of one entry per triangle.
Scalp make_scalp(TriangleMesh mesh);

/// The point's position, cm.
Vec3 scalp_position(const Scalp& scalp, const MeshPoint& point);

/// The smooth normal: the interpolated vertex normals, unit length. If they cancel, the
/// normal of the triangle; +Z if that has no area.
Vec3 scalp_normal(const Scalp& scalp, const MeshPoint& point);

/// The texture coordinates; (0, 0) if the mesh has none.
Vec2 scalp_uv(const Scalp& scalp, const MeshPoint& point);

/// The frame of the surface: columns [normal, tangent, normal x tangent], a rotation. The
/// tangent is dp/du made perpendicular to the smooth normal. If the UVs are missing or
/// degenerate, it comes from the triangle's first edge that is not along the normal, or
/// is a fixed perpendicular: a triangle without area has a frame too. Mirrored UVs do not
/// mirror the frame, because the third column follows from the other two.
Mat3 surface_frame(const Scalp& scalp, const MeshPoint& point);

}  // namespace lancret
