#include "sim/equilibrium/modes.h"

#include <algorithm>
#include <cmath>

#include "guides/base/errors.h"
#include "sim/equilibrium/branch.h"
#include "sim/rod/mass.h"

namespace lancret {

std::vector<double> rod_frequencies(const HangingRod& rod, const Eigen::VectorXd& q,
                                    std::size_t max_count) {
    using Solver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;
    const Solver stiffness(scaled_hessian(rod, rod_hessian(rod, q)));
    const Eigen::VectorXd& rates = stiffness.eigenvalues();
    const double neutral = neutral_eigenvalue(rod);
    require(rates(0) > -neutral,
            "rod_frequencies: the shape is not a minimum of the energy");
    Eigen::Index slack = 0;
    while (slack < rates.size() && rates(slack) < neutral) ++slack;
    const Eigen::Index rest = rates.size() - slack;

    // In the basis of the Hessian's eigenvectors. Directions without stiffness move such
    // that they carry no momentum: the Schur complement of M.
    const Eigen::MatrixXd& axes = stiffness.eigenvectors();
    Eigen::MatrixXd mass =
        axes.transpose() * scaled_hessian(rod, rod_mass(rod, q)) * axes;
    Eigen::MatrixXd stiff = mass.bottomRightCorner(rest, rest);
    if (slack > 0) {
        const Eigen::MatrixXd across = mass.topRightCorner(slack, rest);
        stiff -= across.transpose() * mass.topLeftCorner(slack, slack)
                                          .completeOrthogonalDecomposition()
                                          .solve(across);
    }
    const Eigen::VectorXd soft = rates.tail(rest).cwiseSqrt().cwiseInverse();
    stiff = (soft.asDiagonal() * stiff * soft.asDiagonal()).eval();
    const Eigen::VectorXd periods = Solver(stiff, Eigen::EigenvaluesOnly).eigenvalues();

    std::vector<double> out(std::min<std::size_t>(max_count, slack), 0.);
    // Round-off of the singular M is 1e-16 of the largest.
    for (Eigen::Index i = rest; i-- > 0 && out.size() < max_count;) {
        if (!(periods(i) > 1e-13 * periods(rest - 1))) break;
        out.push_back(1 / std::sqrt(periods(i)));
    }
    return out;
}

}  // namespace lancret
