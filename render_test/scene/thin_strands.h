#pragma once
// Strands thinner than a pixel: drawn wider, and let through by as much.

#include <span>
#include <vector>

#include "procedural/curves/curves.h"
#include "render_test/scene/camera.h"

namespace lancret {

/// Raises radii in place, so that a strand is at least `pixels` wide in each picture of
/// `height` pixels that these cameras take: chosen once for them all, by the one in which
/// a pixel is smallest there. Control points behind every camera stay as they are.
/// Returns the radii from before, [points], cm, for HairSceneOptions::true_radii: what is
/// hit counts for true radius / drawn radius. Throws std::invalid_argument unless
/// `pixels` >= 0 and finite and `height` > 0.
std::vector<float> widen_thin_strands(Curves& curves, std::span<const Camera> cameras,
                                      int height, float pixels);

/// Radius of a segment at u by the radii of its control points: as axis_point's for
/// B-splines, linear for Hermite.
float radius_at(const Curves& curves, std::span<const float> radii, std::uint32_t segment,
                float u);

}  // namespace lancret
