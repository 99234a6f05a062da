#pragma once
// The table [material] of a groom.

#include "guides/toml/table.h"
#include "render_test/material/hair_colour.h"
#include "render_test/material/lambert.h"

namespace lancret {

/// Reads the materials of strands and of the mesh; docs/rendering.md lists the keys.
/// `groom_shading` selects the fast shading of groom_shading.h. Throws InputError.
void read_material(const TomlTable& material, HairMaterial& hair, MeshMaterial& mesh,
                   bool& groom_shading);

}  // namespace lancret
