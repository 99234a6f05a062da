#pragma once
// Motion across the picture while the shutter is open.

#include <span>

#include "render_test/scene/camera.h"
#include "render_test/scene/embree_scene.h"

namespace lancret {

/// How far the point at `hit` moves from ray time 0 to 1, in pixels of a picture of
/// `height`: x to the right, y up. Straight from the first of `times` to the last, for
/// the axis of a strand or the point of a triangle. Zero if there are fewer than two
/// times or if either end is not in front of the camera.
Vec2f screen_motion(std::span<const SceneTime> times, const Camera& camera, int height,
                    const Hit& hit);

}  // namespace lancret
