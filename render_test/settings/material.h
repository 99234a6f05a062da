#pragma once
// The table [material] of a groom.

#include "guides/toml/table.h"
#include "render_test/material/hair_colour.h"
#include "render_test/material/lambert.h"

namespace lancret {

/// Reads the material of strands and of what they grow on; docs/rendering.md has the
/// keys. `groom_shading` is whether strands are shown the cheap way. Throws InputError.
void read_material(const TomlTable& material, HairMaterial& hair, MeshMaterial& mesh,
                   bool& groom_shading);

}  // namespace lancret
