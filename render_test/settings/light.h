#pragma once
// The table [light] of a groom.

#include <optional>

#include "guides/toml/table.h"
#include "render_test/light/lights.h"

namespace lancret {

/// Reads the lights; nullopt if the groom sets none. `up` is that of the scene. Throws
/// InputError, also if an environment cannot be read.
std::optional<Lights> read_lights(const TomlTable& light, const Vec3f& up);

}  // namespace lancret
