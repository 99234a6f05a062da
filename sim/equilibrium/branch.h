#pragma once
// The equilibria of a hanging rod that continue its natural shape as its weight grows.

#include "sim/rod/energy.h"

namespace lancret {

/// rho S |g| L^3 / EI with the smaller bending stiffness: weight against stiffness.
double weight_number(const HangingRod& rod);

/// D^(-1/2) H D^(-1/2) with D = stiffness_diagonal: dimensionless, I without weight. Its
/// eigenvalues are those of D^-1 H.
Eigen::MatrixXd scaled_hessian(const HangingRod& rod, const Eigen::MatrixXd& hessian);

/// Below this an eigenvalue of scaled_hessian counts as zero: round-off is 1e-16 of the
/// largest ones, which grow like the weight number.
double neutral_eigenvalue(const HangingRod& rod);

/// An equilibrium under rod.gravity times a factor, `weight`, that starts at 0 in the
/// natural shape. Steps follow the branch by a tangent and Newton's method on the exact
/// Hessian, so they do not care whether it is stable.
class RodBranch {
  public:
    /// Throws std::invalid_argument as check_rod does.
    explicit RodBranch(const HangingRod& rod);

    double weight() const { return weight_; }
    const Eigen::VectorXd& q() const { return q_; }
    /// Of the energy, at this weight.
    const Eigen::MatrixXd& hessian() const { return hessian_; }
    bool hessian_is_positive() const { return positive_; }
    double smallest_eigenvalue() const;

    /// Goes on to `weight`; false, and nothing is moved, where Newton's method from the
    /// tangent does not converge surely: a step too long for this branch, or its end.
    bool step_to(double weight);
    /// Newton iterations of the last step.
    int iterations() const { return iterations_; }
    /// Moves to an equilibrium found otherwise.
    void restart(double weight, const Eigen::VectorXd& q);

  private:
    bool factorise();
    Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
    double size(const Eigen::VectorXd& change) const;
    void evaluate(double weight, const Eigen::VectorXd& q);

    HangingRod rod_;
    Eigen::VectorXd stiffness_, natural_, spread_;
    double weight_ = 0;
    Eigen::VectorXd q_, gradient_;
    Eigen::MatrixXd hessian_;
    bool positive_ = true;
    int iterations_ = 0;
    GravityTerms gravity_;
    Eigen::LLT<Eigen::MatrixXd> cholesky_;
    Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
};

}  // namespace lancret
