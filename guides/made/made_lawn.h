#pragma once
// A generated lawn on a gentle hill.

#include "guides/made/made_groom.h"

namespace lancret {

/// Side of the square lawn, cm. It is centred at the origin, Y up.
inline constexpr double kMadeLawn = 60;

/// Makes blades of grass: each leaves the ground near its normal and bows to one side,
/// more towards the tip. The side is mostly random and partly that of a breeze that
/// varies over the lawn. Uses only the settings `strands`, `points`, `shortest`,
/// `longest`, `length_spread` and `seed`. `head` and `scalp` are the ground, with UVs;
/// there is no parting. Strand i does not depend on the count; all segments of a strand
/// have the same length, to rounding. Throws std::invalid_argument as make_groom does.
MadeGroom make_lawn(const MadeGroomSettings& settings);

}  // namespace lancret
