#pragma once
// What a scene's strands and mesh must hold to before Embree reads them.

#include "render_test/scene/embree_scene.h"

namespace lancret {

/// Throws std::invalid_argument where an index points outside its array, counts do not
/// agree or a UV is not finite. `mesh` may be null.
void check_indices(const Curves& curves, const TriangleMesh* mesh);

/// Throws std::invalid_argument where a time differs from the first in more than places,
/// widths and UVs.
void check_alike(const SceneTime& first, const SceneTime& other);

}  // namespace lancret
