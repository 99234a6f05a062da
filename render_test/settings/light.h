#pragma once
// The table [light] of a groom.

#include <optional>

#include "guides/toml/table.h"
#include "render_test/light/lights.h"

namespace lancret {

/// Reads what shines; nothing where the groom names no light. `up` is the scene's. Throws
/// InputError, also for an environment that cannot be read.
std::optional<Lights> read_lights(const TomlTable& light, const Vec3f& up);

}  // namespace lancret
