#pragma once
// How wide strands are in a picture, and what shape they are therefore drawn in.

#include <span>

#include "procedural/curves/curves.h"
#include "render_test/scene/camera.h"

namespace lancret {

/// Strands up to this wide in pixels are drawn flat: of one that is wider its roundness
/// may be seen, where it bends towards the viewer or meets another.
inline constexpr float kFlatPixels = 4;

/// Whether a strand in view of any of the cameras is wider than `pixels` in pictures of
/// `height` pixels. Judged at control points; one counts where it lies in front of the
/// camera and within the picture or a quarter of its size around it.
bool any_wider(const Curves& curves, std::span<const Camera> cameras, int height,
               float pixels);

}  // namespace lancret
