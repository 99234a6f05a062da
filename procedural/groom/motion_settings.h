#pragma once
// What a groom's TOML says of how its head moves: the table [motion].

#include "guides/motion/scalp_pose.h"
#include "guides/toml/table.h"
#include "procedural/groom/groom.h"

namespace lancret {

/// How the head moves; without keys and files it stands still.
struct MotionSettings {
    std::vector<PoseKey> keys;
    Vec3 pivot = Vec3::Zero();  ///< cm
    ObjSequence files;          ///< of the scalp; an empty pattern: none
};

/// Reads the table [motion]; lengths in its files are of a unit of so many cm.
MotionSettings read_motion(const TomlTable& table, double centimetres_per_unit);

/// Reads `pivot` and [[keys]] of a table.
void read_motion_keys(const TomlTable& table, MotionSettings& out);

/// The vector under `key`, within a million in each direction.
std::optional<Vec3> bounded_vector(const TomlTable& table, std::string_view key);

/// The head's motion. `rest` is the scalp at rest, asked for by a mesh sequence alone.
/// Throws InputError where that has none.
ScalpMotion scalp_motion(const MotionSettings& settings, const TriangleMesh* rest,
                         double frames_per_second);

/// Where the head is at a frame; nothing where it stands still. Throws InputError.
ScalpPoseAt head_pose(const MotionSettings& motion, const GroomSettings& groom);

}  // namespace lancret
