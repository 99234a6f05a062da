#pragma once
// The list [[colliders]] of a groom's TOML.

#include <filesystem>
#include <variant>
#include <vector>

#include "guides/bodies/colliders.h"
#include "guides/motion/motion_settings.h"

namespace lancret {

/// A body besides the head.
struct ColliderSettings {
    std::variant<Capsule, std::filesystem::path> shape;  ///< a path is that of an OBJ
    bool with_head = false;                              ///< moves as the head does
    MotionSettings motion;                               ///< its own keys, otherwise
};

/// Reads [[colliders]] of `toml`. `head` is the motion of the head. Throws InputError,
/// also for a body that moves with a head that deforms.
std::vector<ColliderSettings> read_colliders(const TomlTable& toml,
                                             const MotionSettings& head);

}  // namespace lancret
