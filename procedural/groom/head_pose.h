#pragma once
// The pose of a groom's head over time.

#include "guides/motion/motion_settings.h"
#include "guides/motion/scalp_pose.h"
#include "procedural/groom/groom.h"

namespace lancret {

/// The head's pose at each frame; empty if the head stands still. Throws InputError.
ScalpPoseAt head_pose(const MotionSettings& motion, const GroomSettings& groom);

}  // namespace lancret
