#pragma once
// How to follow an equilibrium as the weight grows, over the folds at which it ends.

#include <functional>

#include "sim/equilibrium/branch.h"

namespace lancret {

enum class WalkEvent {
    step,  ///< the branch went on
    fold,  ///< it ends here: told before the rod snaps
    snap,  ///< the rod has gone downhill to another branch, at a little more weight
};

/// Walks `branch` of `rod` to the weight factor `most`, calling visit(event) at each
/// event until it says false. No step is longer than `growth` times the weight, so that
/// nothing shorter is missed; infinity lets the steps grow as they may. False where the
/// walk did not get there: visit ended it, or it took more than 5000 steps or 100 snaps.
bool walk_branch(RodBranch& branch, const HangingRod& rod, double max_weight,
                 double growth, const std::function<bool(WalkEvent)>& visit);

}  // namespace lancret
