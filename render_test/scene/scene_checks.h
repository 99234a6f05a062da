#pragma once
// Validation of strands and mesh before Embree reads them.

#include <span>

#include "render_test/scene/embree_scene.h"

namespace lancret {

/// Throws std::invalid_argument if an index points outside its array, counts do not
/// agree, a UV is not finite, or an option is out of range; also if a time differs from
/// the first in more than positions, widths and UVs.
void check_scene(std::span<const SceneTime> times, const HairSceneOptions& options);

}  // namespace lancret
