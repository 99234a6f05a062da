#pragma once
// Small free vibrations of a hanging rod.

#include <vector>

#include "sim/rod/energy.h"

namespace lancret {

/// The angular frequencies about the equilibrium `q`, 1/s, lowest first, each as often as
/// it has modes: a straight round rod's come in pairs. Without damping and without rotary
/// inertia. M is singular for straight rods, so it is 1 / omega^2 that is solved for: M x
/// = lambda H x. Motions without mass have no frequency and are not counted; those
/// without stiffness have frequency 0. At most `most`. Throws std::invalid_argument where
/// q is no minimum.
std::vector<double> rod_frequencies(const HangingRod& rod, const Eigen::VectorXd& q,
                                    std::size_t max_count);

}  // namespace lancret
