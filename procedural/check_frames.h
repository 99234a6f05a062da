#pragma once
// The check of many frames: the worst over them, with the frame where it is.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "procedural/check.h"
#include "procedural/check_guides.h"

namespace lancret {

/// What was found in one frame.
struct FrameCheck {
    int frame = 0;           ///< as an artist counts
    bool pass = true;        ///< children and guides
    std::size_t failed = 0;  ///< children beyond a tolerance
    double severity = 0;     ///< of the worst child
    StrandCheck largest;     ///< each figure's largest size over the children
    std::size_t outside_hull = 0, outside_bound = 0, non_finite = 0;
    GuideCheck guides;
};

/// What was found in all frames. Every strand's findings are kept of one frame alone.
struct FramesReport {
    std::vector<FrameCheck> frames;
    CheckReport worst;    ///< of the frame whose worst child is worst, the first such
    int worst_frame = 0;  ///< that is

    bool pass() const;
};

/// Adds what was found in the next frame.
void add_frame(FramesReport& report, int frame, CheckReport children,
               const GuideCheck& guides);

/// A table: each figure's maximum over the frames, its tolerance, and in which frame it
/// is; then those of the guides. Ends with a line PASS or FAIL.
std::string frames_table(const FramesReport& report);

/// {pass, frames: [{frame, pass, failed, orthogonality.{max}, length.{...}, ...,
/// guides.{orthogonality, length_change, root_cm, root_guide, finite}}],
/// worst_over_frames: {orthogonality.{max, frame, tolerance}, ..., guides.{...}},
/// worst_frame}
nlohmann::json frames_json(const FramesReport& report);

}  // namespace lancret
