#pragma once
// A box, as a mesh and as its signed distance.

#include <algorithm>

#include "guides/mesh/triangle_mesh.h"

namespace lancret {

/// The box |x_i| <= half_i, facing outwards: 8 vertices and 12 triangles, 3 to 6 at each
/// corner.
inline TriangleMesh box_mesh(const Vec3f& half) {
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < 8; ++i) {
        mesh.positions.push_back({i & 1 ? half.x() : -half.x(),
                                  i & 2 ? half.y() : -half.y(),
                                  i & 4 ? half.z() : -half.z()});
    }
    const std::array<std::uint32_t, 4> faces[] = {{0, 4, 6, 2}, {1, 3, 7, 5},
                                                  {0, 1, 5, 4}, {2, 6, 7, 3},
                                                  {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& f : faces) {
        mesh.triangles.push_back({f[0], f[1], f[2]});
        mesh.triangles.push_back({f[0], f[2], f[3]});
    }
    return mesh;
}

inline double box_distance(const Vec3& half, const Vec3& x) {
    const Vec3 d = x.cwiseAbs() - half;
    return d.cwiseMax(0.0).norm() + std::min(d.maxCoeff(), 0.0);
}

}  // namespace lancret
