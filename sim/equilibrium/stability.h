#pragma once
// At what weight a hanging rod buckles.

#include <vector>

#include "sim/rod/energy.h"

namespace lancret {

struct StabilityChange {
    double weight = 0;    ///< a factor on rod.gravity
    bool stable = false;  ///< beyond it
    bool fold = false;    ///< the branch ends there, and the rod snaps to another
};

/// Where the equilibrium that continues the natural shape stops or starts to be a minimum
/// of the energy, as the weight factor grows to `most`: the Hessian is singular there. To
/// 1e-9 of the weight, at a fold to 1e-6. At most `count` of them. A change that is taken
/// back within 10 % of the weight may be missed. Throws std::invalid_argument as
/// check_rod does.
std::vector<StabilityChange> stability_changes(const HangingRod& rod, double max_weight,
                                               std::size_t count);

}  // namespace lancret
