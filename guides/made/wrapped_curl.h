#pragma once
// Strands wound into curls, to turn a straight groom into a curly one.

#include <cstdint>

#include "guides/strand/strands.h"

namespace lancret {

struct CurlSettings {
    double radius = 0.02;  ///< relative to the strand's length, 0 to 1
    double turns = 8;      ///< from root to tip, 0 to kMaxCurlTurns
    double jitter = 0;     ///< relative standard deviation of the turns, 0 to 1
};
constexpr double kMaxCurlTurns = 100;

/// Winds each strand as a helix about its curve. The curl grows in over the first fifth,
/// so that roots stay in place. Phase (uniform) and turns (normal, at least 0) are drawn
/// by hash of (seed, strand). The result has Catmull-Rom points, the same number per
/// strand, and no attributes; strands without a length are left out. Throws
/// std::invalid_argument if a setting is out of range.
Strands wrapped_in_curls(const Strands& strands, const CurlSettings& curl,
                         std::uint64_t seed);

}  // namespace lancret
