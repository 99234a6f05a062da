#pragma once
// Small free vibrations of a hanging rod.

#include <vector>

#include "sim/rod/energy.h"

namespace lancret {

/// At most `max_count` angular frequencies about the equilibrium `q`, 1/s, lowest first,
/// one per mode: those of a straight round rod come in pairs. Without damping and without
/// rotary inertia. M is singular for straight rods, so the problem is solved for
/// 1 / omega^2: M x = lambda H x. Motions without mass have no frequency and are omitted;
/// those without stiffness have frequency 0. Throws std::invalid_argument if q is not a
/// minimum.
std::vector<double> rod_frequencies(const HangingRod& rod, const Eigen::VectorXd& q,
                                    std::size_t max_count);

}  // namespace lancret
