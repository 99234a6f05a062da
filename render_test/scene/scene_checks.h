#pragma once
// Validation of strands and mesh before Embree reads them.

#include "render_test/scene/embree_scene.h"

namespace lancret {

/// Throws std::invalid_argument if an index points outside its array, counts do not agree
/// or a UV is not finite. `mesh` may be null.
void check_indices(const Curves& curves, const TriangleMesh* mesh);

/// Throws std::invalid_argument if a time differs from the first in more than positions,
/// widths and UVs.
void check_alike(const SceneTime& first, const SceneTime& other);

}  // namespace lancret
