#include "procedural/groom/groom_source.h"

#include <fmt/format.h>

#include <utility>

#include "guides/base/errors.h"
#include "guides/files/guide_cache.h"
#include "guides/toml/text.h"

namespace lancret {

namespace {

/// The .toml file that a guide cache was made from; empty if it names none or the file
/// is missing. The guides are then the groom.
std::filesystem::path groom_of_cache(const std::filesystem::path& cache) {
    const std::filesystem::path groom = guide_cache_info(cache).groom;
    std::error_code ignored;
    const bool exists = std::filesystem::is_regular_file(groom, ignored);
    return exists && groom.extension() == ".toml" ? groom : std::filesystem::path();
}

}  // namespace

SourcedGroom read_groom_source(const GroomSource& source) {
    const bool from_text = source.text || source.path.empty();
    const std::string extension = source.path.extension().string();
    const bool cache = !from_text && extension == ".h5";
    const bool strands = !from_text && extension == ".hair";
    if (!from_text && extension != ".toml" && !cache && !strands) {
        throw InputError(
            fmt::format("{}: expected a .toml, .hair or .h5 file", source.path.string()));
    }
    const std::filesystem::path file = cache ? groom_of_cache(source.path) : source.path;
    const bool without_toml = strands || (cache && file.empty());
    const std::string name = source.path.empty()         ? "groom"
                             : from_text || without_toml ? source.path.string()
                                                         : file.string();
    const std::filesystem::path folder =
        from_text && !source.folder.empty() ? source.folder : file.parent_path();
    std::string text = from_text      ? source.text.value_or("")
                       : without_toml ? std::string()
                                      : toml_file_text(file);
    TomlTable toml = TomlTable::from_text(text, name, folder);
    for (const GroomParameter& parameter : source.parameters) {
        if (parameter.text) {
            toml.set_override(parameter.name, *parameter.text);
        } else {
            toml.set_override(parameter.name, parameter.number);
        }
    }
    SourcedGroom out{read_groom(toml, name), {}, toml, std::move(text)};
    GroomSettings& groom = out.groom;
    out.motion = read_motion(toml.table("motion"), groom.scene.centimetres_per_unit());
    if (without_toml) {
        groom.strands_file = source.path;
    } else if (cache) {
        groom.guides_file = source.path;
    }
    if (source.strands && !groom.guides_file.empty()) {
        throw InputError(fmt::format(
            "{}: contains its own guides, {}, and cannot take the host's strands", name,
            groom.guides_file.string()));
    }
    groom.own_strands = source.strands;
    groom.own_scalp = source.scalp;
    if (groom.own_strands) groom.strands_file.clear();
    if (groom.own_scalp) groom.scalp_file.clear();
    return out;
}

}  // namespace lancret
