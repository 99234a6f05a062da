#pragma once
// How far an anchored child can move, from how far what it is made of does.

#include "procedural/blend/blend.h"

namespace lancret {

/// A child between two times as `detail` sees it: its guides, at which places no matter.
struct AnchoredTimes {
    const Child<double>& before;
    const Child<double>& after;
    const GuideProfiles<double>& profiles_before;
    const GuideProfiles<double>& profiles_after;
};

/// A bound, cm, on how far any place of the child that `detail` makes goes between the
/// two times, from its root; docs/time.md derives it. It is made from the guides' frames
/// and spines alone, without the child: with alpha the angle by which the frame of the
/// heaviest guide's copy turns at a place, dv the change of the tilt's speed and q the
/// quaternion from spine to spine, no frame of the child turns by more than
///     4.9 alpha + 2.4 |dv| + 2 pi |dq| / (|q| + |q'|),
/// and no place moves by more than twice the length times the largest of these.
double anchored_motion_limit(const AnchoredTimes& times);

}  // namespace lancret
