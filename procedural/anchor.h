#pragma once
// Anchoring: a strand turned so that its spine runs where its guides' spines run.

#include "procedural/blend.h"

namespace lancret {

/// Turns the frames of a synthesised strand so that its spine follows the spine of the
/// child's guides, and moves the places after them. Two rotations at each place, both as
/// smooth along the strand as the spines are, so that its own curvature and torsion stay
/// nearly what they were:
///   - the tangent is tilted about the spine so that the strand gets on as fast as its
///     guides do;
///   - the spine is turned into the direction of the guides'.
/// A strand that is one of its guides, with all the weight, stays as it is. The length
/// stays exact: between two frames there is one helix.
template <class T>
void anchor(const Child<T>& child, const GuideProfiles<T>& guides,
            std::span<HelixState<T>> states);

}  // namespace lancret
