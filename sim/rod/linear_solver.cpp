#include "sim/rod/linear_solver.h"

#include <Eigen/Dense>
#include <Eigen/IterativeLinearSolvers>

namespace lancret {

SolveReport solve(RodSystem& system, LinearSolver solver, std::span<const Vec3> diagonal,
                  std::span<const Vec3> load, std::span<Vec3> x, DenseSystem& dense) {
    SolveReport report;
    if (solver == LinearSolver::recursion) {
        system.solve(diagonal, load, x);
        return report;
    }
    system.assemble(diagonal, load, dense.matrix, dense.force);
    Eigen::Map<Eigen::VectorXd> out(x.front().data(), Eigen::Index(3 * x.size()));
    const auto solved_by = [&](const auto& solution) {
        report.solved = solution.info() == Eigen::Success;
        out = solution.solve(dense.force);
    };
    if (solver == LinearSolver::cholesky) {
        solved_by(Eigen::LLT<Eigen::MatrixXd>(dense.matrix));
    } else if (solver == LinearSolver::ldlt) {
        const Eigen::LDLT<Eigen::MatrixXd> factor(dense.matrix);
        solved_by(factor);
        report.solved = report.solved && factor.isPositive();
    } else if (solver == LinearSolver::conjugate_gradient) {
        Eigen::ConjugateGradient<Eigen::MatrixXd, Eigen::Lower | Eigen::Upper> gradient;
        gradient.setTolerance(1e-14);
        gradient.compute(dense.matrix);
        out = gradient.solve(dense.force);
        report.iterations = int(gradient.iterations());
        report.solved = gradient.error() < 1e-6;
    } else {
        const Eigen::BDCSVD<Eigen::MatrixXd> svd(
            dense.matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
        out = svd.solve(dense.force);
        const auto& values = svd.singularValues();
        report.condition = values[0] / values[values.size() - 1];
    }
    return report;
}

}  // namespace lancret
