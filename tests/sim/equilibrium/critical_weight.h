#pragma once
// The weight at which a rod buckles.

#include <optional>

#include "sim/equilibrium/stability.h"

namespace lancret {

/// The weight at the first stability change up to `max_weight`; nullopt if there is none.
inline std::optional<double> critical_weight(const HangingRod& rod, double max_weight) {
    const std::vector<StabilityChange> changes = stability_changes(rod, max_weight, 1);
    if (changes.empty()) return std::nullopt;
    return changes[0].weight;
}

}  // namespace lancret
