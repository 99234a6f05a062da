#pragma once
// Level of detail of a preview: the size of each chunk of strands in its pictures.

#include <span>
#include <vector>

#include "render_test/plugin/groom.h"
#include "render_test/scene/camera.h"

namespace lancret {

/// Area of each chunk in pixels, [chunks]: that of the rectangle around its projected
/// box, the largest over all cameras. The box is that of the groom's first time, so that
/// nothing pops over time. Throws InputError.
std::vector<double> chunk_pixels(const PluginGroom& groom,
                                 std::span<const Camera> cameras, int height);

}  // namespace lancret
