#pragma once
// Guides at a time between two frames of a cache. Places are never interpolated: every
// guide keeps its length exactly and stays a Super-Helix of the same segments.

#include <span>

#include "guides/base/rigid_pose.h"
#include "guides/helix/guides.h"

namespace lancret {

/// Frames around a time. `before` and `after` may be missing; they are the neighbours of
/// `from` and `to`.
struct GuideKeys {
    const Guides *from = nullptr, *to = nullptr;
    const Guides *before = nullptr, *after = nullptr;
};

/// How the scalp carries the guides' roots at those frames and at the time between, each
/// [guides] or, for a neighbour that is missing, empty. What is interpolated is told in
/// what carries it: where the scalp moves on an arc so do the roots, and hair at rest on
/// a turning head turns with it.
struct RootCarriers {
    std::vector<RigidPose> from, to, before, after, at;
};

/// What of a guide is interpolated in time.
enum class InTime {
    /// The frame at each joint, on SO(3), by the Catmull-Rom cubic of the four frames'
    /// rotation vectors from `from`'s; a missing neighbour is the frame beside it, and
    /// without both this is the geodesic, at an eased rate. A segment's Darboux vector is
    /// the logarithm of its ends' relative rotation. What goes wrong at the root does not
    /// swing the tip.
    frames,
    /// Darboux vectors, linear by component, and root frames along the geodesic.
    curvatures,
};

/// The guides at `share` (0..1) of the way from one frame to the next. Root positions go
/// as curvatures or frames do: on a line or a cubic. Lengths are those of `from`. Turns
/// of more than half a circle in a segment are kept, and so are turns of that much in
/// time that build up along a guide. A share of 0 or 1 gives the bits of that frame.
///
/// Throws std::invalid_argument where the share is not within 0..1, the frames differ in
/// guides, segments or lengths, or there are not as many carriers as guides.
Guides guides_between(const GuideKeys& keys, double share,
                      InTime in_time = InTime::frames,
                      const RootCarriers* carriers = nullptr);

}  // namespace lancret
