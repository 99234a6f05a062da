#pragma once
// Strands wound into curls: a groom without curls stands in for one with them.

#include <cstdint>

#include "guides/strand/strands.h"

namespace lancret {

struct CurlSettings {
    double radius = 0.02;  ///< over the strand's length, 0 to 1
    double turns = 8;      ///< from root to tip, 0 to kMaxCurlTurns
    double jitter = 0;     ///< of the turns from strand to strand, relative, 0 to 1:
                           ///< the standard deviation
};
constexpr double kMaxCurlTurns = 100;

/// Winds each strand round itself as a helix about its own curve. The curl grows in over
/// the first fifth, so that roots stay where they are. Phase (even) and turns (normal,
/// not below 0) are drawn by hash of (seed, strand). The strands come out as points to
/// pass through, all of one number, without attributes; a strand without a length is left
/// out. Throws std::invalid_argument where a setting is out of its range.
Strands wrapped_in_curls(const Strands& strands, const CurlSettings& curl,
                         std::uint64_t seed);

}  // namespace lancret
