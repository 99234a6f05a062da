#pragma once
// Following an equilibrium as the weight grows, across the folds at which it ends.

#include <functional>

#include "sim/equilibrium/branch.h"

namespace lancret {

enum class WalkEvent {
    step,  ///< the branch was followed by one step
    fold,  ///< the branch ends; the rod has not snapped yet
    snap,  ///< the rod has descended to another branch at a slightly larger weight
};

/// Follows `branch` of `rod` to the weight factor `max_weight`, calling visit(event) at
/// each event until that returns false. No step is longer than `growth` times the weight,
/// so that no change over a longer range is missed; infinity does not limit the steps.
/// Returns false if the walk did not get there: visit returned false, or it would have
/// taken more than 5000 steps or 100 snaps.
bool walk_branch(RodBranch& branch, const HangingRod& rod, double max_weight,
                 double growth, const std::function<bool(WalkEvent)>& visit);

}  // namespace lancret
