#pragma once
// Which side of a mesh a place is on, and how far from it.

#include <array>
#include <limits>
#include <vector>

#include "guides/mesh/closest_point.h"

namespace lancret {

/// What a query on a mesh says.
struct MeshDistance {
    /// cm, negative behind the surface; +infinity where there is nothing within reach.
    double distance = std::numeric_limits<double>::infinity();
    Vec3 normal = Vec3::UnitZ();  ///< unit, outward: the gradient of the distance
    Vec3 point = Vec3::Zero();    ///< closest on the surface, cm
    std::uint32_t triangle = 0;
};

/// A mesh with what telling its sides needs: normals of its triangles, edges and
/// vertices, those of vertices weighted by angle, so that the sign is right wherever the
/// closest point is (Baerentzen and Aanaes 2005). Vertices at equal positions count as
/// one and triangles without area weigh nothing. Triangles face outwards,
/// counter-clockwise.
///
/// A mesh is closed where each edge has as many triangles one way round as the other.
/// Else it has borders, and no inside: a place is behind it only where the closest point
/// is not on a border; round a border the distance is positive.
class SignedDistance {
  public:
    /// Throws std::invalid_argument where the mesh has no triangles, an index points
    /// nowhere or a position is no place.
    explicit SignedDistance(const TriangleMesh& mesh);

    /// The signed distance at `place` (cm, finite), where the surface is within `within`
    /// of it. Safe to call from many threads, allocates nothing.
    MeshDistance at(const Vec3& place,
                    double within = std::numeric_limits<double>::infinity()) const;
    bool closed() const { return closed_; }

  private:
    /// Of a triangle: its own, those of edges (0, 1), (1, 2), (2, 0) and of its corners.
    /// Not of unit length; zero where the surface has no side (its triangles fold back).
    struct Normals {
        Vec3 face = Vec3::Zero();
        std::array<Vec3, 3> edges, corners;
        std::array<bool, 3> border_edges{}, border_corners{};
    };
    void set_edges(const std::vector<std::array<std::uint32_t, 3>>& triangles);
    void set_corners(const TriangleMesh& mesh,
                     const std::vector<std::array<std::uint32_t, 3>>& triangles);

    ClosestPoint closest_;
    std::vector<Normals> normals_;  ///< [triangles]
    bool closed_ = true;
};

}  // namespace lancret
