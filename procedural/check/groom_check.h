#pragma once
// The whole check of a groom: children, chunks, guides and motion, frame by frame.

#include <functional>
#include <span>

#include "procedural/check/check.h"
#include "procedural/check/chunks.h"
#include "procedural/check/frames.h"
#include "procedural/expand/class_choice.h"
#include "procedural/motion/moving_groom.h"

namespace lancret {

/// The check of a groom at several frames.
struct GroomCheck {
    FramesReport frames;
    ChunkCheck chunks;      ///< worst_of the frames
    AdaptedReport adapted;  ///< the worst of the frames; 0 if the groom has one class
    Curves curves;          ///< of the last frame
    double expand_seconds = 0, check_seconds = 0;  ///< wall time, summed over the frames
    bool pass = true;  ///< whether children and chunks pass, of a cache also guides and
                       ///< steps
};

/// Expands and checks a groom at `frames` (frame numbers in ascending order, {0} for a
/// groom without a cache), and the motion of children between successive frames. Leaves
/// `ready` posed at the last frame. Calls `progress` with the fraction that is done.
/// Throws InputError.
GroomCheck check_groom(ReadyGroom& ready, const GroomTimes& times,
                       std::span<const double> frames, const CheckTolerances& tolerances,
                       const std::function<void(double)>& progress = {});

}  // namespace lancret
