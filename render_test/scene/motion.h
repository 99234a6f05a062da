#pragma once
// How far things move across the picture while the shutter is open.

#include <span>

#include "render_test/scene/camera.h"

namespace lancret {

/// How far what `hit` met moves from ray time 0 to 1, in pixels of a picture of `height`:
/// x to the right, y up. Straight from the first of `times` to the last (of a strand its
/// axis, of a mesh the point of the triangle); zero where there is one time or none, and
/// where either end is not in front of the camera.
Vec2f screen_motion(std::span<const SceneTime> times, const Camera& camera, int height,
                    const Hit& hit);

}  // namespace lancret
