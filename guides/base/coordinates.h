#pragma once

#include <cmath>

#include "guides/base/types.h"

namespace lancret {

/// The largest coordinate that a file may hold, cm: far larger than any set, and small
/// enough that the fourth power of a distance fits a float.
inline constexpr float kLargestCoordinate = 1e9f;

/// Whether `p` is finite and within kLargestCoordinate.
inline bool is_place(const Vec3f& p) {
    // A NaN fails every comparison.
    return std::abs(p.x()) <= kLargestCoordinate &&
           std::abs(p.y()) <= kLargestCoordinate && std::abs(p.z()) <= kLargestCoordinate;
}

}  // namespace lancret
