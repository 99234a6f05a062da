#pragma once
// Level of detail of a preview: how large each chunk of strands is in its pictures.

#include <span>
#include <vector>

#include "render_test/plugin/groom.h"
#include "render_test/scene/camera.h"

namespace lancret {

/// [chunks], pixels: the rectangle round what a camera sees of a chunk's box, of that
/// camera which sees most of it. The box is of the groom's first time, so that nothing
/// pops with time. Throws InputError.
std::vector<double> chunk_pixels(const PluginGroom& groom,
                                 std::span<const Camera> cameras, int height);

}  // namespace lancret
