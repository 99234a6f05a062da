#pragma once
// The equilibria of a hanging rod that continue its natural shape as its weight grows.

#include "sim/rod/energy.h"

namespace lancret {

/// rho S |g| L^3 / EI with the smaller bending stiffness: the ratio of weight to
/// stiffness.
double weight_number(const HangingRod& rod);

/// D^(-1/2) H D^(-1/2) with D = stiffness_diagonal: dimensionless, I without weight. It
/// has the eigenvalues of D^-1 H.
Eigen::MatrixXd scaled_hessian(const HangingRod& rod, const Eigen::MatrixXd& hessian);

/// The threshold below which an eigenvalue of scaled_hessian counts as zero: round-off is
/// 1e-16 of the largest eigenvalues, which are proportional to the weight number.
double neutral_eigenvalue(const HangingRod& rod);

/// An equilibrium under `weight` times rod.gravity, starting at weight 0 in the natural
/// shape. Steps follow the branch by its tangent and Newton's method with the exact
/// Hessian, whether or not it is stable.
class RodBranch {
  public:
    /// Throws as validate_rod does.
    explicit RodBranch(const HangingRod& rod);

    double weight() const { return weight_; }
    const Eigen::VectorXd& q() const { return q_; }
    /// Hessian of the energy at the current weight.
    const Eigen::MatrixXd& hessian() const { return hessian_; }
    bool hessian_is_positive() const { return positive_; }
    double smallest_eigenvalue() const;

    /// Moves to `weight`. Returns false and changes nothing if Newton's method from the
    /// tangent does not converge reliably: the step is too long, or the branch ends.
    bool step_to(double weight);
    /// Number of Newton iterations of the last step.
    int iterations() const { return iterations_; }
    /// Moves to an equilibrium that was found by other means.
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
