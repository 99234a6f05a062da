#pragma once
// The signed distance of a place from a mesh.

#include <array>
#include <limits>
#include <vector>

#include "guides/mesh/closest_point.h"

namespace lancret {

/// The closest point of a mesh and the signed distance to it.
struct MeshDistance {
    /// cm, negative behind the surface; +infinity if nothing is within reach.
    double distance = std::numeric_limits<double>::infinity();
    Vec3 normal = Vec3::UnitZ();  ///< unit, outward: the gradient of the distance
    Vec3 point = Vec3::Zero();    ///< closest on the surface, cm
    std::uint32_t triangle = 0;
};

/// A mesh with the normals that give its distance a sign: those of triangles, edges and
/// vertices, the latter weighted by angle, so that the sign is right wherever the closest
/// point is (Baerentzen and Aanaes 2005). Vertices at equal positions count as one, and
/// triangles without area have no weight. Triangles are counter-clockwise from outside.
///
/// A mesh is closed if each edge has as many triangles in one direction as in the other.
/// Otherwise it has borders and no inside: a place is behind it only if the closest point
/// is not on a border; around a border the distance is positive.
class SignedDistance {
  public:
    /// Throws std::invalid_argument if the mesh has no triangles, an index is out of
    /// range, or a position is not finite or beyond kLargestCoordinate.
    explicit SignedDistance(const TriangleMesh& mesh);

    /// The signed distance at `place` (cm, finite) if the surface is within `within` of
    /// it. May be called from several threads; does not allocate.
    MeshDistance at(const Vec3& place,
                    double within = std::numeric_limits<double>::infinity()) const;
    bool closed() const { return closed_; }

  private:
    /// The normals of a triangle, of its edges (0, 1), (1, 2), (2, 0) and of its corners.
    /// Not of unit length; zero if the surface has no side there (its triangles fold
    /// back).
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
