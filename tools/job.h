#pragma once
// What a subcommand works on: a groom and how to show and simulate it.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "guides/motion/scalp_pose.h"
#include "procedural/groom/groom_source.h"
#include "render_test/settings/preview.h"
#include "tools/dynamics_settings.h"

namespace lancret {

struct GroomOptions;

/// A groom and how to show and simulate it.
struct Job {
    GroomSource source;  ///< the groom's file, with the command's options as overrides
    GroomSettings groom;
    PreviewSettings preview;
    DynamicsSettings dynamics;
    std::string settings_text;                  ///< of the TOML file; empty without one
    ScalpPoseAt pose_at;                        ///< null: the scalp stays at rest
    std::vector<std::filesystem::path> inputs;  ///< files that no output may replace
};

/// Reads GROOM.toml, FILE.hair or GUIDES.h5, with the options as overrides. Throws
/// InputError.
Job read_job(const GroomOptions& options);

/// Throws InputError if the strands have more than 2^32 control points: as counted, or as
/// the settings imply before any work is done.
void check_points(const GroomSettings& groom, std::uint64_t strands, int intervals,
                  std::uint64_t points);
void check_points(const GroomSettings& groom);

}  // namespace lancret
