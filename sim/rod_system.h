#pragma once
// A rod's positions, linearised about its curvatures, and the linear-time solution of
//     (M + D) x = f,    M = weight int J^T J ds + point terms,    D diagonal.
//
// M is never assembled: a composite recursion runs from tip to root and back. Spatial
// vectors are (angular; linear), in space, about the start of the segment at hand.

#include <vector>

#include "sim/rod.h"
#include "sim/rod_points.h"

namespace lancret {

class RodSystem {
  public:
    /// Linearises about `curvatures`. Each quadrature point of `layout` is drawn to its
    /// target by a spring of strength `weight` for each cm of rod, which gives M, and the
    /// generalised force f = weight int J^T (target - place) ds. Allocates only when the
    /// number of segments grows.
    void linearize(const HelixState<double>& root, std::span<const double> lengths,
                   std::span<const Vec3> curvatures, const PointLayout& layout,
                   const PointVectors& targets, double weight);

    /// weight int |target - place|^2 / 2 ds at the curvatures of linearize().
    double half_square() const { return half_square_; }

    int segments() const { return int(segments_.size()); }
    /// Frame and place at the start of a segment, in space.
    HelixState<double> start(int segment) const {
        return {segments_[segment].frame, segments_[segment].start};
    }

    /// Adds a spring of stiffness matrix H (symmetric, positive semi-definite) and a
    /// force at the point at arc length u from the start of a segment: J^T H J to M and
    /// J^T force to f.
    void add_point(int segment, double u, const Mat3& stiffness, const Vec3& force);

    /// Solves by the recursion. `diagonal` is D, each above 0, and `load` is added to f;
    /// all are [segments]. M + D is symmetric and positive definite always, and so is
    /// every 3 x 3 block that is factored here, a Schur complement of it.
    void solve(std::span<const Vec3> diagonal, std::span<const Vec3> load,
               std::span<Vec3> x);

    /// M + D as a matrix and f + load as a vector, [3 segments], to be solved by other
    /// means.
    void assemble(std::span<const Vec3> diagonal, std::span<const Vec3> load,
                  Eigen::MatrixXd& matrix, Eigen::VectorXd& force) const;

  private:
    struct Segment {
        Vec3 darboux;
        double length;
        Mat3 frame;          ///< in space
        Vec3 start, offset;  ///< of its start; from its start to its end
        Mat3 turn, move;     ///< what dk does to its end: F V, F J
        Mat3 gram;           ///< w J^T J
        Mat3 moment, force;  ///< w R x J, w J in space
        Mat3 aa, al, ll;     ///< inertia: angular-angular, angular-linear, linear
        Vec3 load;           ///< w J^T e
        Vec3 moment_load, force_load;
        Mat3 factor;  ///< Cholesky factor of the Schur complement
        Mat3 wa, wl;  ///< U factor^-T
        Vec3 z;
    };

    std::vector<Segment> segments_;
    double half_square_ = 0;
};

}  // namespace lancret
