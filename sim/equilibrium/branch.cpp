#include "sim/equilibrium/branch.h"

#include <algorithm>
#include <cmath>

namespace lancret {

double weight_number(const HangingRod& rod) {
    const double softest = rod.section.stiffness.tail<2>().minCoeff();
    return rod.section.linear_density * rod.gravity.norm() *
           std::pow(rod_length(rod), 3) / softest;
}

Eigen::MatrixXd scaled_hessian(const HangingRod& rod, const Eigen::MatrixXd& hessian) {
    const Eigen::VectorXd scale = stiffness_diagonal(rod).cwiseSqrt().cwiseInverse();
    return scale.asDiagonal() * hessian * scale.asDiagonal();
}

double neutral_eigenvalue(const HangingRod& rod) {
    return 1e-9 + 1e-13 * weight_number(rod);
}

RodBranch::RodBranch(const HangingRod& rod) : rod_(rod) {
    validate_rod(rod);
    stiffness_ = stiffness_diagonal(rod);
    natural_ = natural_curvatures(rod);
    spread_.resize(natural_.size());
    for (std::size_t i = 0; i < rod.segments(); ++i) {
        spread_.segment<3>(3 * i).setConstant(rod.lengths[i] * rod_length(rod));
    }
    restart(0, natural_);
}

double RodBranch::smallest_eigenvalue() const {
    using Solver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;
    const Eigen::MatrixXd scaled = scaled_hessian(rod_, hessian_);
    return Solver(scaled, Eigen::EigenvaluesOnly).eigenvalues()(0);
}

/// Root mean square of a change of curvature over the rod, times the rod's length.
double RodBranch::size(const Eigen::VectorXd& change) const {
    return std::sqrt(change.cwiseAbs2().dot(spread_));
}

void RodBranch::evaluate(double weight, const Eigen::VectorXd& q) {
    gravity_terms(rod_, q, Derivatives::second, gravity_);
    gradient_ = stiffness_.cwiseProduct(q - natural_) + weight * gravity_.gradient;
    hessian_ = weight * gravity_.hessian;
    hessian_.diagonal() += stiffness_;
}

bool RodBranch::factorise() {
    cholesky_.compute(hessian_);
    positive_ = cholesky_.info() == Eigen::Success;
    if (!positive_) lu_.compute(hessian_);
    return hessian_.allFinite();
}

Eigen::VectorXd RodBranch::solve(const Eigen::VectorXd& right) const {
    if (positive_) return cholesky_.solve(right);
    return lu_.solve(right);
}

void RodBranch::restart(double weight, const Eigen::VectorXd& q) {
    weight_ = weight;
    q_ = q;
    evaluate(weight_, q_);
    factorise();
}

bool RodBranch::step_to(double weight) {
    constexpr int kMaxIterations = 8;
    const Eigen::VectorXd before = q_;
    const double weight_before = weight_;
    const double reach = 0.3 + 0.1 * size(before);
    // Newton's method is reliable while each correction is much smaller than the last.
    const double converged = 1e-9 * (1 + size(before));

    Eigen::VectorXd q = q_ - (weight - weight_) * solve(gravity_.gradient);
    bool good = size(q - before) < reach;
    double last = reach;
    for (iterations_ = 1; good; ++iterations_) {
        evaluate(weight, q);
        good = factorise();
        if (!good) break;
        const Eigen::VectorXd correction = -solve(gradient_);
        const double moved = size(correction);
        good = moved < converged || (moved < 0.5 * last && iterations_ < kMaxIterations);
        if (!good) break;
        q += correction;
        last = moved;
        if (moved < converged) break;
    }
    if (good) {
        restart(weight, q);
    } else {
        restart(weight_before, before);
    }
    return good;
}

}  // namespace lancret
