#include "sim/equilibrium/stability.h"

#include <algorithm>
#include <cmath>

#include "sim/equilibrium/walk.h"

namespace lancret {

namespace {

/// The weight between `from` and `to` at which the smallest eigenvalue changes sign, by
/// the Illinois variant of false position, which halves the value at a side that is kept.
double eigenvalue_zero(const RodBranch& from, const RodBranch& to) {
    double low = from.weight(), high = to.weight();
    double value_low = from.smallest_eigenvalue(), value_high = to.smallest_eigenvalue();
    const double sign = value_low > value_high ? 1 : -1;
    int kept = 0;
    for (int i = 0; i < 100 && high - low > 1e-10 * high; ++i) {
        const double guess = high - value_high * (high - low) / (value_high - value_low);
        // Slightly inside, so that both ends close in.
        const double inset = 2e-11 * high;
        RodBranch branch = from;
        if (!branch.step_to(std::clamp(guess, low + inset, high - inset))) break;
        const double value = branch.smallest_eigenvalue();
        const bool below = sign * value > 0;
        (below ? low : high) = branch.weight();
        (below ? value_low : value_high) = value;
        if (kept == (below ? 1 : -1)) (below ? value_high : value_low) /= 2;
        kept = below ? 1 : -1;
    }
    return std::abs(value_low) < std::abs(value_high) ? low : high;
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
            // A stable rod that snaps has lost its stability, even if it lands on a
            // stable branch.
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
