#pragma once
// The roots of children.

#include <cstdint>
#include <span>
#include <vector>

#include "guides/mesh/triangle_mesh.h"

namespace lancret {

/// Roots at rest. With a scalp, each also has its place on the mesh, so that it can
/// follow the mesh as it moves.
struct Roots {
    std::vector<Vec3f> positions;    ///< [size], cm
    std::vector<Vec3f> normals;      ///< [size], unit, out of the scalp
    std::vector<Vec2f> uvs;          ///< [size]; empty without a scalp
    std::vector<MeshPoint> places;   ///< [size]; empty without a scalp
    std::vector<std::uint32_t> ids;  ///< [size], unique strand ids; empty: 0, 1 ...
    std::vector<float> widths;  ///< [size], relative to full density; empty: all are 1

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

/// The roots `which`, in this order, with their ids.
Roots picked(const Roots& roots, std::span<const std::uint32_t> which);

}  // namespace lancret
