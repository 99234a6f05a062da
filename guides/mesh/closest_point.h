#pragma once

#include <limits>
#include <memory>

#include "guides/mesh/triangle_mesh.h"

namespace lancret {

/// The closest point of a mesh.
struct ClosestResult {
    MeshPoint point;
    Vec3 position = Vec3::Zero();  ///< cm, in double precision; MeshPoint is rounded
    /// u and v of the point before rounding. On an edge one is 0, or u + v = 1 to 2 ulp.
    Vec2 uv = Vec2::Zero();
    double distance = 0;  ///< cm, from the query's place
};

/// Finds the closest point of a mesh with a tree over its triangles. A triangle without
/// area counts as a segment or a point.
class ClosestPoint {
  public:
    /// Copies the positions and the triangles. Throws std::invalid_argument if the mesh
    /// has no triangles or an index is out of range.
    explicit ClosestPoint(const TriangleMesh& mesh);
    ~ClosestPoint();
    ClosestPoint(ClosestPoint&&) noexcept;
    ClosestPoint& operator=(ClosestPoint&&) noexcept;

    /// The closest point to `place` (cm, finite); of several triangles at the same
    /// distance the one with the lowest index, so the result is deterministic. May be
    /// called from several threads. Searches only within `within` (cm, >= 0), which is
    /// much faster; if it finds nothing, the distance is +infinity and the other fields
    /// are meaningless.
    ClosestResult closest(const Vec3& place,
                          double within = std::numeric_limits<double>::infinity()) const;

  private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

}  // namespace lancret
