#pragma once
// Strands thinner than a pixel: drawn wider, and transparent by the same factor.

#include <span>
#include <vector>

#include "procedural/curves/curves.h"
#include "render_test/scene/camera.h"

namespace lancret {

/// Raises radii in place, so that a strand is at least `pixels` wide in pictures of
/// `height` pixels. One radius serves all cameras: that for the camera with the smallest
/// pixels there. Control points behind every camera are unchanged. Returns the previous
/// radii, [points], cm, for HairSceneOptions::true_radii: hits count by true radius /
/// drawn radius. Throws std::invalid_argument unless `pixels` >= 0 and finite and
/// `height` > 0.
std::vector<float> widen_thin_strands(Curves& curves, std::span<const Camera> cameras,
                                      int height, float pixels);

/// Radius of a segment at u, interpolated from the radii of its control points: as by
/// axis_point for B-splines, linearly for Hermite.
float radius_at(const Curves& curves, std::span<const float> radii, std::uint32_t segment,
                float u);

}  // namespace lancret
