#pragma once
// A limit on how far a child of blend detail moves between two times.

#include "procedural/blend/blend.h"

namespace lancret {

/// A child and its guides at two times.
struct AnchoredTimes {
    const Child<double>& before;
    const Child<double>& after;
    const GuideProfiles<double>& profiles_before;
    const GuideProfiles<double>& profiles_after;
};

/// An upper limit, cm, on the motion of any place of the child of blend detail between
/// the two times, relative to its root; docs/time.md derives it. It follows from the
/// guides' frames and spines only. Let alpha be the angle by which the frame of the
/// heaviest guide's copy turns at a place, dv the change of the tilt's speed and q the
/// quaternion from spine to spine. Then no frame of the child turns by more than
///     4.9 alpha + 2.4 |dv| + 2 pi |dq| / (|q| + |q'|),
/// and no place moves by more than twice the length times the largest of these.
double anchored_motion_limit(const AnchoredTimes& times);

}  // namespace lancret
