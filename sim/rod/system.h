#pragma once
// A rod's positions, linearised about its curvatures, and the linear-time solution of
//     (M + D) x = f,    M = weight int J^T J ds + point terms,    D diagonal.
//
// M is never assembled: a composite recursion runs from tip to root and back. Spatial
// vectors are (angular; linear), in world axes, about the start of the current segment.

#include <vector>

#include "sim/rod/points.h"
#include "sim/rod/rod.h"
#include "sim/segment/block.h"

namespace lancret {

class RodSystem {
  public:
    /// Linearises about `curvatures`. Each quadrature point of `layout` is drawn to its
    /// target by a spring of strength `weight` per cm of rod, which gives M and the
    /// generalised force f = weight int J^T (target - position) ds. Allocates only if the
    /// number of segments grows.
    void linearize(const HelixState<double>& root, std::span<const double> lengths,
                   std::span<const Vec3> curvatures, const PointLayout& layout,
                   const PointVectors& targets, double weight);

    /// weight int |target - position|^2 / 2 ds at the curvatures of linearize().
    double half_square() const { return half_square_; }

    int segments() const { return int(segments_.size()); }
    /// Frame and position at the start of a segment, world axes.
    HelixState<double> start(int segment) const {
        const SegmentBlock& s = segments_[std::size_t(segment)];
        return {Mat3::Map(s.frame), Vec3::Map(s.start)};
    }

    /// A point of the rod and its derivative with respect to its segment's curvatures.
    struct Point {
        int segment;
        Vec3 position;  ///< world axes, cm
        Mat3 jacobian;  ///< world axes, cm^2
    };
    /// The point at arc length u (cm) from the start of a segment.
    Point point(int segment, double u) const;

    /// Adds a spring of stiffness matrix H (symmetric, positive semi-definite) and a
    /// force at a point: J^T H J to M and J^T force to f.
    void add(const Point& point, const Mat3& stiffness, const Vec3& force);

    /// The generalised force f, [segments].
    void forces(std::span<Vec3> f) const;

    /// Solves by the recursion. `diagonal` is D, all above 0, and `load` is added to f;
    /// all are [segments]. M + D is always symmetric and positive definite, and so is
    /// every 3 x 3 block that is factored here, a Schur complement of it.
    void solve(std::span<const Vec3> diagonal, std::span<const Vec3> load,
               std::span<Vec3> x);

    /// M + D as a matrix and f + load as a vector, [3 segments], for other solvers.
    void assemble(std::span<const Vec3> diagonal, std::span<const Vec3> load,
                  Eigen::MatrixXd& matrix, Eigen::VectorXd& force) const;

  private:
    std::vector<SegmentBlock> segments_;
    double half_square_ = 0;
};

}  // namespace lancret
