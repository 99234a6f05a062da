#pragma once
// The check of many frames: the worst over them, with the frame where it is.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "procedural/check/check.h"
#include "procedural/check/child_motion.h"
#include "procedural/check/guides.h"

namespace lancret {

/// What was found in one frame.
struct FrameCheck {
    double frame = 0;        ///< as an artist counts
    bool pass = true;        ///< children and guides
    std::size_t failed = 0;  ///< children beyond a tolerance
    double severity = 0;     ///< of the worst child
    StrandCheck largest;     ///< each figure's largest size over the children
    std::size_t outside_hull = 0, outside_bound = 0, non_finite = 0;
    GuideCheck guides;
};

/// What was found between a frame and the next that was looked at.
struct StepCheck {
    double from = 0, to = 0;  ///< frames
    TemporalReport motion;
    bool has_limit = false;  ///< children of this blend have a bound
    bool pass = true;        ///< and keep it
};

/// What was found in all frames. Every strand's findings are kept of one frame alone.
struct FramesReport {
    std::vector<FrameCheck> frames;
    CheckReport worst;       ///< of the frame whose worst child is worst, the first such
    double worst_frame = 0;  ///< that is
    std::vector<StepCheck> steps;  ///< between successive frames

    bool pass() const;
};

/// Adds what was found in the next frame.
void add_frame(FramesReport& report, double frame, CheckReport children,
               const GuideCheck& guides);

/// Adds how children moved from one frame to the next. Fails where the blend has a bound
/// and a child goes beyond it by more than round-off.
void add_step(FramesReport& report, double from, double to, const TemporalReport& motion);

/// A table: each figure's maximum over the frames, its tolerance, and in which frame it
/// is; then those of the guides, and the children's steps beside their guides'. Ends with
/// a line PASS or FAIL.
std::string frames_table(const FramesReport& report);

/// {pass, frames: [{frame, pass, failed, orthogonality.{max}, length.{...}, ...,
/// guides.{orthogonality, length_change, root_cm, root_guide, finite}}],
/// worst_over_frames: {orthogonality.{max, frame, tolerance}, ..., guides.{...}},
/// worst_frame, temporal: {amplification, share_of_limit, child, from, to, child_cm,
/// guides_cm, largest_child_cm, largest_guides_cm, steps: [{from, to, amplification,
/// ...}]}}; temporal only where there are steps
nlohmann::json frames_json(const FramesReport& report);

}  // namespace lancret
