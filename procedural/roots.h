#pragma once
// Where children stand.

#include <cstdint>
#include <vector>

#include "guides/triangle_mesh.h"

namespace lancret {

/// Roots at rest. With a scalp each names its place on the mesh, to follow it as it
/// moves.
struct Roots {
    std::vector<Vec3f> positions;   ///< [size], cm
    std::vector<Vec3f> normals;     ///< [size], unit, out of the scalp
    std::vector<Vec2f> uvs;         ///< [size], or empty without a scalp
    std::vector<MeshPoint> places;  ///< [size], or empty without a scalp

    std::size_t size() const { return positions.size(); }
    std::size_t bytes() const {
        return positions.size() * sizeof(Vec3f) + normals.size() * sizeof(Vec3f) +
               uvs.size() * sizeof(Vec2f) + places.size() * sizeof(MeshPoint);
    }
};

}  // namespace lancret
