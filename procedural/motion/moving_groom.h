#pragma once
// A groom in time: guides of a cache's frames and between them, on a scalp that moves.

#include "procedural/groom/ready_groom.h"
#include "procedural/motion/groom_times.h"

namespace lancret {

/// Everything of one frame that is not the same in all.
struct FrameState {
    Guides guides;
    ClassedGuides classed;          ///< the guides as strands read them
    std::vector<Vec3> scalp_roots;  ///< [guides], cm: where the scalp has their roots
    ScalpPose pose;                 ///< of the scalp
};

/// What the binding of `ready` is at rest; to be called before any frame. The points of a
/// strand are the same in all frames, so where a groom does not say how many intervals it
/// has, they and the strands' classes are measured on frames spread over the whole cache
/// too: hair that moves bends more than hair at rest. The binding's children may change
/// their order with their classes. Throws InputError.
RestPlaces prepare_frames(ReadyGroom& ready, const GroomTimes& times);

/// The number of intervals at which curves of `basis` stay within `tolerance` cm of the
/// strands: at rest, and at frames spread over the cache. At most `most`, then further
/// off: `reached`, where it is not null, becomes the farthest that was seen, cm. Throws
/// InputError.
int intervals_in_time(const ReadyGroom& ready, const GroomTimes& times, CurveBasis basis,
                      double tolerance, int most, double* reached = nullptr);

/// How finely the children of each guide are cut so that curves of `basis` stay within
/// `tolerance` cm, of at most `finest` intervals; measured at the same times.
StrandClasses classes_in_time(const ReadyGroom& ready, const GroomTimes& times,
                              CurveBasis basis, double tolerance, int finest);

/// Brings the binding of `ready` to a frame. `rest` is what the binding was before the
/// first frame. Where no motion is known, the scalp stays at rest. Throws InputError.
FrameState go_to_frame(ReadyGroom& ready, const RestPlaces& rest, const GroomTimes& times,
                       double frame);

/// The guides of a cache at a frame or between two: see guides_between. Where it is known
/// how the scalp moves, the roots follow it: those at `guide_places`. Throws InputError.
Guides guides_at(const GroomTimes& times, std::span<const MeshPoint> guide_places,
                 double frame);

/// Whether guides and scalp are at all `frames` just where they are at the first of them.
/// Throws InputError.
bool is_still(const GroomTimes& times, std::span<const MeshPoint> guide_places,
              std::span<const double> frames);

}  // namespace lancret
