#pragma once
// Solvers of a step's linear system [Bergbom07, Sec. 5.1.2].

#include <span>

#include "sim/rod/system.h"

namespace lancret {

enum class LinearSolver { recursion, cholesky, ldlt, conjugate_gradient, svd };

/// Properties of the matrix that a solver finds.
struct SolveReport {
    bool solved = true;    ///< false if the matrix was not positive definite
    double condition = 0;  ///< largest over smallest singular value; svd only
    int iterations = 0;    ///< conjugate_gradient only
};

/// Buffers of the solvers that need the matrix.
struct DenseSystem {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd force;
};

/// Solves (M + D) x = f + load; see RodSystem. All but `recursion` assemble the matrix
/// and take O(N^3) time (conjugate_gradient: O(N^2) per iteration), and allocate.
SolveReport solve(RodSystem& system, LinearSolver solver, std::span<const Vec3> diagonal,
                  std::span<const Vec3> load, std::span<Vec3> x, DenseSystem& dense);

}  // namespace lancret
