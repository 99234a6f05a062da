#pragma once
// How finely strands must be cut for their control points to follow them.

#include "guides/guides.h"
#include "procedural/curves.h"

namespace lancret {

/// How far, in cm, the emitted curve of a strand lies from the strand itself at most,
/// measured between its places.
double emission_distance(const Guides& guides, int intervals, CurveBasis basis);

/// The number of intervals, a multiple of the guides' segments, at which every guide's
/// emitted curve stays within `tolerance` cm of the guide; at most `most`, or one
/// multiple beyond it.
int intervals_within(const Guides& guides, double tolerance, CurveBasis basis,
                     int most = 128);

}  // namespace lancret
