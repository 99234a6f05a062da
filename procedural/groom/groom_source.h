#pragma once
// Where a groom's settings come from: files of several kinds, a text, values laid over.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "procedural/groom/groom.h"
#include "procedural/groom/motion_settings.h"

namespace lancret {

/// A value for the key `name` of a groom's TOML, such as "strands.count".
struct GroomParameter {
    std::string name;
    std::optional<std::string> text;  ///< else a number, or 0 or 1 of a boolean
    double number = 0;
};

struct GroomSource {
    std::filesystem::path path;       ///< .toml, .hair or .h5; or empty
    std::optional<std::string> text;  ///< of a TOML, in place of the file's
    std::filesystem::path folder;     ///< that `text` names files from; empty: of `path`
    std::vector<GroomParameter> parameters;
    std::shared_ptr<const Strands> strands;     ///< in place of the groom's file, or none
    std::shared_ptr<const TriangleMesh> scalp;  ///< in place of the scalp's file, or none
};

struct SourcedGroom {
    GroomSettings groom;
    MotionSettings motion;  ///< of its head
    std::string text;       ///< of the TOML as it was read; empty where there is none
};

/// The tables of a groom's TOML that say what grows; the others belong to who shows it.
inline constexpr std::string_view kGroomTables[] = {
    "scene", "guides", "scalp", "strands", "regions", "partings", "width"};

/// The groom of a source; of one with neither path nor text, the groom that Lancret makes
/// or that the source holds. The tables [camera], [light], [material], [render],
/// [dynamics] and [[colliders]] belong to others and are not looked at. Throws
/// InputError.
SourcedGroom read_groom_source(const GroomSource& source);

}  // namespace lancret
