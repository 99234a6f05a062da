#pragma once
// Which pair of a sampler's random dimensions is used for what.

#include <cstdint>

namespace lancret {

/// Two pairs for place and time, then this many for each bounce.
inline constexpr std::uint32_t kCameraPairs = 2, kBouncePairs = 4;

/// Far from those of bounces: Russian roulette (one pair per bounce), the choice among
/// thin strands, the lens, and the choice of lobes.
inline constexpr std::uint32_t kRoulettePair = 0x10000, kThinPair = 0x20000,
                               kLensPair = 0x30000, kLobesPair = 0x40000;

}  // namespace lancret
