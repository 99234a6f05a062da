#pragma once
// Reads a groom's settings from a file of any supported kind or from a text.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "guides/motion/motion_settings.h"
#include "procedural/groom/groom.h"

namespace lancret {

/// An override of one key of a groom's TOML.
struct GroomParameter {
    std::string name;                 ///< such as "strands.count"
    std::optional<std::string> text;  ///< nullopt: the value is `number`
    double number = 0;                ///< 0 or 1 for a boolean
};

struct GroomSource {
    std::filesystem::path path;       ///< .toml, .hair or .h5; may be empty
    std::optional<std::string> text;  ///< TOML that replaces the contents of `path`
    std::filesystem::path folder;     ///< base of paths in `text`; empty: that of `path`
    std::vector<GroomParameter> parameters;
    std::shared_ptr<const Strands> strands;     ///< replace the groom's; may be null
    std::shared_ptr<const TriangleMesh> scalp;  ///< replaces the groom's; may be null
};

/// What a source sets. Its TOML is still open: the caller reads the tables that it needs
/// itself, leaves those that it ignores, and then calls `toml.finish()`, which rejects
/// every key that was not read.
struct SourcedGroom {
    GroomSettings groom;
    MotionSettings motion;  ///< of the head
    TomlTable toml;         ///< with the parameters as overrides
    std::string text;       ///< that `toml` was parsed from; empty without a TOML
};

/// Reads the groom's tables and [motion]. A source with neither path nor text gives the
/// groom that Lancret generates, or the strands that the source holds. Throws InputError.
SourcedGroom read_groom_source(const GroomSource& source);

}  // namespace lancret
