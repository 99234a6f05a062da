#pragma once
// The weights at which a hanging rod buckles.

#include <vector>

#include "sim/rod/energy.h"

namespace lancret {

struct StabilityChange {
    double weight = 0;    ///< a factor on rod.gravity
    bool stable = false;  ///< beyond this weight
    bool fold = false;    ///< the branch ends here and the rod snaps to another
};

/// The first `count` weight factors up to `max_weight` at which the equilibrium that
/// continues the natural shape stops or starts to be a minimum of the energy: the Hessian
/// is singular there. Accurate to 1e-9 of the weight, at a fold to 1e-6. A change that is
/// reversed within 10 % of the weight may be missed. Throws as validate_rod does.
std::vector<StabilityChange> stability_changes(const HangingRod& rod, double max_weight,
                                               std::size_t count);

}  // namespace lancret
