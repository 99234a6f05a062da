#pragma once
// Minima of a hanging rod's energy, from any start.

#include "sim/rod/energy.h"

namespace lancret {

struct RodMinimum {
    Eigen::VectorXd q;
    bool converged = false;
    double smallest_eigenvalue = 0;  ///< of scaled_hessian
    int escapes = 0;                 ///< number of saddles that were left
};

enum class Saddles { leave, keep };

/// Descends from `start` by Newton's method with a modified Hessian and a line search. A
/// stationary point that is not a minimum is left along its direction of most negative
/// curvature. At most 2000 iterations. Of the two signs of that direction, which give
/// mirror images if the rod is symmetric, it takes the one that bends towards n1; if
/// neither does, towards n2; else the one of positive twist. With Saddles::keep the
/// search ends at any stationary point and does not break a symmetry of `start`.
RodMinimum rod_minimum(const HangingRod& rod, const Eigen::VectorXd& start,
                       Saddles saddles = Saddles::leave);

}  // namespace lancret
