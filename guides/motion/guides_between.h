#pragma once
// Guides at a time between two frames of a cache. Points along a guide are never
// interpolated: every guide keeps its length exactly and stays a Super-Helix of the same
// segments.

#include <span>

#include "guides/base/rigid_pose.h"
#include "guides/helix/guides.h"

namespace lancret {

/// The frames around a time. `before` and `after`, the neighbours of `from` and `to`, may
/// be null.
struct GuideKeys {
    const Guides *from = nullptr, *to = nullptr;
    const Guides *before = nullptr, *after = nullptr;
};

/// The poses by which the scalp carries the guides' roots, at the frames of GuideKeys and
/// at the time `at` between them; each [guides], or empty for a neighbour that is null.
/// Guides are interpolated relative to their carriers: if the scalp moves on an arc, so
/// do the roots, and hair at rest on a turning head turns with it.
struct RootCarriers {
    std::vector<RigidPose> from, to, before, after, at;
};

/// The quantity of a guide that is interpolated in time.
enum class InTime {
    /// The frame at each joint, on SO(3), by the Catmull-Rom cubic of the rotation
    /// vectors
    /// from the frame of `from` to those of the four keys. A missing neighbour is
    /// replaced
    /// by the frame next to it; without both this is the geodesic, at an eased rate. A
    /// segment's Darboux vector is the logarithm of its ends' relative rotation. An error
    /// at the root does not swing the tip.
    frames,
    /// Darboux vectors, linear by component, and root frames along the geodesic.
    curvatures,
};

/// The guides at `share` in [0, 1] of the way from `from` to `to`. Root positions move on
/// a line for `curvatures`, on a cubic for `frames`. Lengths are those of `from`. Turns
/// of more than half a circle are kept, within a segment as well as in time if they build
/// up along a guide. A share of 0 or 1 returns the bits of that frame. Without `carriers`
/// guides are interpolated in space.
///
/// Throws std::invalid_argument if the share is outside [0, 1], the frames differ in
/// guides, segments or lengths, or there is not one carrier per guide.
Guides guides_between(const GuideKeys& keys, double share,
                      InTime in_time = InTime::frames,
                      const RootCarriers* carriers = nullptr);

}  // namespace lancret
