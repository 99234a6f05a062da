#include "procedural/groom_source.h"

#include <fmt/format.h>

#include "guides/errors.h"
#include "guides/guide_cache.h"

namespace lancret {

namespace {

constexpr std::string_view kOthersTables[] = {"camera", "light",    "material",
                                              "render", "dynamics", "colliders"};

/// The groom that a cache of guides names, where it is a .toml that is there; else
/// nothing: then the guides stand by themselves.
std::filesystem::path groom_of_cache(const std::filesystem::path& cache) {
    const std::filesystem::path groom = guide_cache_info(cache).groom;
    std::error_code unknown;  // counts as not there
    const bool there = std::filesystem::is_regular_file(groom, unknown);
    return there && groom.extension() == ".toml" ? groom : std::filesystem::path();
}

}  // namespace

SourcedGroom read_groom_source(const GroomSource& source) {
    const bool from_text = source.text || source.path.empty();
    const std::string extension = source.path.extension().string();
    const bool cache = !from_text && extension == ".h5";
    const bool strands = !from_text && extension == ".hair";
    if (!from_text && extension != ".toml" && !cache && !strands) {
        throw InputError(fmt::format("{}: a groom is a .toml, .hair or .h5 file",
                                     source.path.string()));
    }
    const std::filesystem::path file = cache ? groom_of_cache(source.path) : source.path;
    const bool by_itself = strands || (cache && file.empty());
    const std::string name = source.path.empty()      ? "groom"
                             : from_text || by_itself ? source.path.string()
                                                      : file.string();
    const std::filesystem::path folder =
        source.folder.empty() ? source.path.parent_path() : source.folder;
    TomlTable toml = from_text
                         ? TomlTable::from_text(source.text.value_or(""), name, folder)
                     : by_itself ? TomlTable::from_text("", name)
                                 : TomlTable::from_file(file);
    for (const GroomParameter& parameter : source.parameters) {
        if (parameter.text) {
            toml.lay_over(parameter.name, *parameter.text);
        } else {
            toml.lay_over(parameter.name, parameter.number);
        }
    }
    SourcedGroom out{read_groom(toml, name), {}};
    Groom& groom = out.groom;
    out.motion = read_motion(toml.table("motion"), groom.scene.centimetres_per_unit());
    for (const std::string_view key : kOthersTables) toml.leave(key);
    toml.finish();
    if (by_itself) {
        groom.strands_file = source.path;
    } else if (cache) {
        groom.guides_file = source.path;
    }
    groom.own_strands = source.strands;
    groom.own_scalp = source.scalp;
    if (groom.own_strands) groom.strands_file.clear();
    if (groom.own_scalp) groom.scalp_file.clear();
    return out;
}

}  // namespace lancret
