#pragma once
// The gradient of a hanging rod's energy.

#include "sim/rod/energy.h"

namespace lancret {

/// dE/dq of the whole energy.
inline Eigen::VectorXd rod_gradient(const HangingRod& rod, const Eigen::VectorXd& q) {
    GravityTerms gravity;
    gravity_terms(rod, q, Derivatives::first, gravity);
    return stiffness_diagonal(rod).cwiseProduct(q - natural_curvatures(rod)) +
           gravity.gradient;
}

}  // namespace lancret
