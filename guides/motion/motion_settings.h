#pragma once
// The table [motion] of a groom's TOML, and the keys of anything else that moves.

#include <optional>
#include <string_view>
#include <vector>

#include "guides/motion/scalp_motion.h"
#include "guides/toml/table.h"

namespace lancret {

/// How the head moves; without keys and files it stands still.
struct MotionSettings {
    std::vector<PoseKey> keys;
    Vec3 pivot = Vec3::Zero();  ///< cm
    ObjSequence files;          ///< the scalp of each frame; an empty pattern: none

    bool deforms() const { return !files.pattern.empty(); }
    bool still() const { return keys.empty() && !deforms(); }
};

/// Reads the table [motion]. One unit of length in its files is `centimetres_per_unit`.
/// Throws InputError.
MotionSettings read_motion(const TomlTable& table, double centimetres_per_unit);

/// Reads `pivot` and [[keys]] of a table. Throws InputError.
void read_motion_keys(const TomlTable& table, MotionSettings& out);

/// The vector under `key`; nullopt if the key is missing. Throws InputError if a
/// component is beyond a million.
std::optional<Vec3> bounded_vector(const TomlTable& table, std::string_view key);

/// The motion of a head or body. `rest` is the scalp at rest, which only a sequence of
/// meshes needs; may be null otherwise. Throws InputError if the sequence has none.
ScalpMotion scalp_motion(const MotionSettings& settings, const TriangleMesh* rest,
                         double frames_per_second);

}  // namespace lancret
