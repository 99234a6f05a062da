#pragma once
// A lawn that Lancret makes by itself, on a gentle hill.

#include "guides/made/made_groom.h"

namespace lancret {

/// The lawn's side, cm; it lies about the origin, Y up, and is cut off straight.
inline constexpr double kMadeLawn = 60;

/// Makes blades of grass: each leaves the ground near its normal and bows to one side,
/// more towards the tip. The side is its own for the most part, and of a breeze that
/// varies over the lawn. Of the settings it takes `strands`, `points`, `shortest`,
/// `longest`, `length_spread` and `seed`. `head` and `scalp` are the ground, with UVs;
/// there is no parting. Strand i does not depend on the count; all segments of a strand
/// have the same length, to rounding. Throws std::invalid_argument as make_groom.
MadeGroom make_lawn(const MadeGroomSettings& settings);

}  // namespace lancret
