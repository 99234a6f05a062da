#pragma once
// A groom at the frames of a guide cache and between them, on a moving scalp.

#include "procedural/groom/ready_groom.h"
#include "procedural/motion/groom_times.h"
#include "procedural/motion/posed_binding.h"

namespace lancret {

/// What changes from frame to frame.
struct FrameState {
    Guides guides;
    ClassedGuides classed;          ///< `guides` in the form that `expand` takes
    std::vector<Vec3> scalp_roots;  ///< [guides], root positions on the posed scalp, cm
    ScalpPose pose;                 ///< of the scalp
};

/// Returns the rest state of the binding of `ready`; call it before any frame. All frames
/// use the same number of points per strand. If the groom does not set the number of
/// intervals, it and the strands' classes are also measured on frames spread over the
/// cache, because moving hair bends more than hair at rest. This may reorder the
/// binding's children by their new classes. Throws InputError.
RestPlaces prepare_frames(ReadyGroom& ready, const GroomTimes& times);

/// The number of intervals with which curves of `basis` stay within `tolerance` cm of the
/// strands, at rest and at frames spread over the cache; at most `most`, even if the
/// distance is then larger. Stores the largest measured distance, cm, in `reached` if it
/// is not null. Throws InputError.
int intervals_in_time(const ReadyGroom& ready, const GroomTimes& times, CurveBasis basis,
                      double tolerance, int most, double* reached = nullptr);

/// The interval counts, at most `finest`, with which the children of each guide stay
/// within `tolerance` cm, for curves of `basis`; measured at the same times.
StrandClasses classes_in_time(const ReadyGroom& ready, const GroomTimes& times,
                              CurveBasis basis, double tolerance, int finest);

/// Moves the binding of `ready` to a frame. `rest` is the result of prepare_frames.
/// Throws InputError.
FrameState go_to_frame(ReadyGroom& ready, const RestPlaces& rest, const GroomTimes& times,
                       double frame);

/// The guides of a cache at a frame or between two frames: see guides_between. With a
/// moving scalp the roots follow it at `guide_places`. Throws InputError.
Guides guides_at(const GroomTimes& times, std::span<const MeshPoint> guide_places,
                 double frame);

/// Whether guides and scalp are identical at all `frames`. Throws InputError.
bool is_still(const GroomTimes& times, std::span<const MeshPoint> guide_places,
              std::span<const double> frames);

}  // namespace lancret
