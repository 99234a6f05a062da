#include "sim/equilibrium/stability.h"

#include <algorithm>
#include <cmath>

#include "sim/equilibrium/walk.h"

namespace lancret {

namespace {

/// Where the smallest eigenvalue changes its sign between `from` and `to`, by false
/// position in which a side that is kept counts half each time (Illinois).
double eigenvalue_zero(const RodBranch& from, const RodBranch& to) {
    double low = from.weight(), high = to.weight();
    double at_low = from.smallest_eigenvalue(), at_high = to.smallest_eigenvalue();
    const double sign = at_low > at_high ? 1 : -1;
    int kept = 0;
    for (int i = 0; i < 100 && high - low > 1e-10 * high; ++i) {
        const double guess = high - at_high * (high - low) / (at_high - at_low);
        // A little inside, so that both ends close in.
        const double inset = 2e-11 * high;
        RodBranch branch = from;
        if (!branch.step_to(std::clamp(guess, low + inset, high - inset))) break;
        const double at = branch.smallest_eigenvalue();
        const bool below = sign * at > 0;
        (below ? low : high) = branch.weight();
        (below ? at_low : at_high) = at;
        if (kept == (below ? 1 : -1)) (below ? at_high : at_low) /= 2;
        kept = below ? 1 : -1;
    }
    return std::abs(at_low) < std::abs(at_high) ? low : high;
}

}  // namespace

std::vector<StabilityChange> stability_changes(const HangingRod& rod, double max_weight,
                                               std::size_t count) {
    std::vector<StabilityChange> out;
    RodBranch branch(rod), before = branch;
    if (weight_number(rod) == 0 || count == 0) return out;
    double fold = 0;
    walk_branch(branch, rod, max_weight, 0.1, [&](WalkEvent event) {
        const bool stable = branch.hessian_is_positive();
        if (event == WalkEvent::fold) {
            fold = branch.weight();
            return true;
        }
        if (event == WalkEvent::snap) {
            // A stable rod that snaps has lost its stability, wherever it lands.
            if (before.hessian_is_positive()) out.push_back({fold, false, true});
            if (stable) out.push_back({fold, true, true});
        } else if (stable != before.hessian_is_positive()) {
            out.push_back({eigenvalue_zero(before, branch), stable, false});
        }
        before = branch;
        return out.size() < count;
    });
    if (out.size() > count) out.resize(count);
    return out;
}

}  // namespace lancret
