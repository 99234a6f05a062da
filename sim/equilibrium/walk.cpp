#include "sim/equilibrium/walk.h"

#include <algorithm>

#include "sim/equilibrium/minimum.h"

namespace lancret {

bool walk_branch(RodBranch& branch, const HangingRod& rod, double max_weight,
                 double growth, const std::function<bool(WalkEvent)>& visit) {
    constexpr int kMaxSteps = 5000, kMaxSnaps = 100;
    // Shorter steps, relative to the weight, mean that the branch turns back.
    constexpr double kShortest = 1e-9;
    // The weight at which bending begins to be felt.
    const double first = 0.05 / std::max(weight_number(rod), 1e-30);
    double step = first;
    int snaps = 0;
    for (int i = 0; branch.weight() < max_weight; ++i) {
        if (i == kMaxSteps) return false;
        step = std::min(step, std::max(first, growth * branch.weight()));
        if (branch.step_to(std::min(max_weight, branch.weight() + step))) {
            if (branch.iterations() <= 3) step *= 2;
            if (!visit(WalkEvent::step)) return false;
        } else if (step > kShortest * std::max(first, branch.weight())) {
            step /= 2;
        } else {
            if (snaps++ == kMaxSnaps || !visit(WalkEvent::fold)) return false;
            HangingRod heavier = rod;
            const double over =
                std::min(max_weight, 1.001 * branch.weight() + 0.01 * first);
            heavier.gravity *= over;
            const RodMinimum below = rod_minimum(heavier, branch.q(), Saddles::keep);
            branch.restart(over, below.q);
            if (!visit(WalkEvent::snap)) return false;
            step = 0.01 * std::max(first, over);
        }
    }
    return true;
}

}  // namespace lancret
