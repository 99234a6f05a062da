#pragma once
// The width of strands in a picture, which decides the shape that they are drawn in.

#include <span>

#include "procedural/curves/curves.h"
#include "render_test/scene/camera.h"

namespace lancret {

/// Strands up to this width in pixels are drawn flat. Wider strands may look round where
/// they bend towards the viewer or meet another.
inline constexpr float kFlatPixels = 4;

/// Whether a strand in view of any camera is wider than `pixels` in pictures of `height`
/// pixels. Tested at control points in front of the camera and within the picture,
/// extended by a quarter of its size.
bool any_wider(const Curves& curves, std::span<const Camera> cameras, int height,
               float pixels);

}  // namespace lancret
