#pragma once

#include <limits>
#include <memory>

#include "guides/mesh/triangle_mesh.h"

namespace lancret {

/// The point of a mesh that is closest to a place.
struct ClosestResult {
    MeshPoint point;
    Vec3 position = Vec3::Zero();  ///< cm, to double precision: MeshPoint rounds
    /// The point's u and v before rounding. 0, or u + v = 1 to 2 ulp, on an edge.
    Vec2 uv = Vec2::Zero();
    double distance = 0;  ///< cm, from the place asked for
};

/// Answers which point of a mesh is closest, by a tree over its triangles. Triangles
/// without area count as the segments or points that they are.
class ClosestPoint {
  public:
    /// Copies what it needs of the mesh. Throws std::invalid_argument where the mesh has
    /// no triangles or an index points nowhere.
    explicit ClosestPoint(const TriangleMesh& mesh);
    ~ClosestPoint();
    ClosestPoint(ClosestPoint&&) noexcept;
    ClosestPoint& operator=(ClosestPoint&&) noexcept;

    /// The closest point to `place` (cm, finite). Of several triangles at the same
    /// distance the one of the lowest index, so the answer is the same each time. Safe to
    /// call from many threads.
    /// Nothing further than `within` (cm, >= 0) is looked for, which is much the faster:
    /// where there is nothing the distance is +infinity and the rest has no meaning.
    ClosestResult closest(const Vec3& place,
                          double within = std::numeric_limits<double>::infinity()) const;

  private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

}  // namespace lancret
