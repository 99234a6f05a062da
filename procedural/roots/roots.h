#pragma once
// Where children stand.

#include <cstdint>
#include <span>
#include <vector>

#include "guides/mesh/triangle_mesh.h"

namespace lancret {

/// Roots at rest. With a scalp each names its place on the mesh, to follow it as it
/// moves.
struct Roots {
    std::vector<Vec3f> positions;   ///< [size], cm
    std::vector<Vec3f> normals;     ///< [size], unit, out of the scalp
    std::vector<Vec2f> uvs;         ///< [size], or empty without a scalp
    std::vector<MeshPoint> places;  ///< [size], or empty without a scalp
    std::vector<std::uint32_t>
        ids;                    ///< [size], of the strands, each once; empty: 0, 1 ...
    std::vector<float> widths;  ///< [size], of a strand over its own; empty: all are 1

    std::size_t size() const { return positions.size(); }
    std::uint32_t id(std::size_t i) const {
        return ids.empty() ? std::uint32_t(i) : ids[i];
    }
    float width(std::size_t i) const { return widths.empty() ? 1 : widths[i]; }
    std::size_t bytes() const {
        return positions.size() * sizeof(Vec3f) + normals.size() * sizeof(Vec3f) +
               uvs.size() * sizeof(Vec2f) + places.size() * sizeof(MeshPoint) +
               ids.size() * sizeof(std::uint32_t) + widths.size() * sizeof(float);
    }
};

/// Some roots, in the order of `which`, with their ids.
Roots picked(const Roots& roots, std::span<const std::uint32_t> which);

}  // namespace lancret
