#pragma once
// Minima of a hanging rod's energy, wherever the search starts.

#include "sim/rod/energy.h"

namespace lancret {

struct RodMinimum {
    Eigen::VectorXd q;
    bool converged = false;
    double smallest_eigenvalue = 0;  ///< of scaled_hessian
    int escapes = 0;                 ///< how often a saddle was left
};

enum class Saddles { leave, keep };

/// Goes downhill from `start` by Newton's method with a shifted Hessian and a line
/// search; a stationary point that is no minimum is left along its most negative
/// direction, until there is none. At most 2000 iterations. Of the two signs, mirror
/// images where the rod has a mirror, the one is taken that bends towards n1; where
/// neither does, towards n2; then that which twists positively. With Saddles::keep the
/// search ends at any stationary point, and a symmetry of `start` is not broken on the
/// way.
RodMinimum rod_minimum(const HangingRod& rod, const Eigen::VectorXd& start,
                       Saddles saddles = Saddles::leave);

}  // namespace lancret
