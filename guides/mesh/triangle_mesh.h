#pragma once
// A triangle mesh as files store it.

#include <array>
#include <cstdint>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

struct TriangleMesh {
    std::vector<Vec3f> positions;                         ///< [vertices], cm
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into positions
    std::vector<std::array<Vec2f, 3>>
        uvs;  ///< [triangles], per corner; empty without UVs
};

/// A point of a mesh: position = (1 - u - v) p0 + u p1 + v p2 of the triangle.
struct MeshPoint {
    std::uint32_t triangle = 0;
    float u = 0, v = 0;
};

}  // namespace lancret
