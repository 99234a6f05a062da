#pragma once
// The check of several frames as text and JSON.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "procedural/check/frames.h"

namespace lancret {

/// A table of each figure's maximum over the frames, its frame and its tolerance: of the
/// children, of the guides, and of the steps between frames. Ends with a line PASS or
/// FAIL.
std::string frames_table(const FramesReport& report);

/// {pass, frames: [{frame, pass, failed, orthogonality.{max}, length.{...}, ...,
/// guides.{orthogonality, length_change, root_cm, root_guide, finite}}],
/// worst_over_frames: {orthogonality.{max, frame, tolerance}, ..., guides.{...}},
/// worst_frame, motion: {amplification, share_of_limit, child, from, to, child_cm,
/// guides_cm, largest_child_cm, largest_guides_cm, steps: [{from, to, amplification,
/// ...}]}}; `motion` only if there are steps.
nlohmann::json frames_json(const FramesReport& report);

}  // namespace lancret
