#pragma once
// The check of several frames: the worst values, and the frames that have them.

#include <vector>

#include "procedural/check/check.h"
#include "procedural/check/child_motion.h"
#include "procedural/check/guides.h"

namespace lancret {

/// The check of one frame.
struct FrameCheck {
    double frame = 0;        ///< frame number
    bool pass = true;        ///< children and guides
    std::size_t failed = 0;  ///< number of children beyond a tolerance
    double severity = 0;     ///< of the worst child
    StrandCheck largest;     ///< largest_figures of the children
    std::size_t outside_hull = 0, out_of_reach = 0, non_finite = 0;  ///< children
    GuideCheck guides;
};

/// The check of the motion between two successive frames.
struct StepCheck {
    double from = 0, to = 0;  ///< frame numbers
    MotionReport motion;
    bool has_limit = false;  ///< whether the blend limits the motion of children
    bool pass = true;        ///< whether they keep that limit
};

struct FramesReport {
    std::vector<FrameCheck> frames;
    CheckReport worst;       ///< all strands of the first frame with the largest severity
    double worst_frame = 0;  ///< number of that frame
    std::vector<StepCheck> steps;  ///< between successive frames

    /// Whether every frame and every step passes.
    bool pass() const;
};

/// Adds the check of the next frame.
void add_frame(FramesReport& report, double frame, CheckReport children,
               const GuideCheck& guides);

/// Adds the motion of children from one frame to the next. The step fails if the blend
/// has a limit and a child exceeds it by more than round-off.
void add_step(FramesReport& report, double from, double to, const MotionReport& motion);

}  // namespace lancret
