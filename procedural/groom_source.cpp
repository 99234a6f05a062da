#include "procedural/groom_source.h"

#include <fmt/format.h>

#include "guides/errors.h"
#include "guides/guide_cache.h"

namespace lancret {

namespace {

constexpr std::string_view kOthersTables[] = {"camera", "light",    "material",
                                              "render", "dynamics", "colliders"};

}  // namespace

Groom groom_of_file(const std::filesystem::path& file) {
    Groom out;
    out.name = file.string();
    out.strands_file = file;
    return out;
}

std::filesystem::path groom_of_cache(const std::filesystem::path& cache) {
    const std::filesystem::path groom = guide_cache_info(cache).groom;
    std::error_code unknown;  // counts as not there
    const bool there = std::filesystem::is_regular_file(groom, unknown);
    return there && groom.extension() == ".toml" ? groom : std::filesystem::path();
}

Groom read_groom_source(const GroomSource& source) {
    const std::string extension = source.path.extension().string();
    const bool cache = !source.text && extension == ".h5";
    const bool strands = !source.text && extension == ".hair";
    if (!source.text && extension != ".toml" && !cache && !strands) {
        throw InputError(fmt::format("{}: a groom is a .toml, .hair or .h5 file",
                                     source.path.string()));
    }
    const std::filesystem::path file = cache ? groom_of_cache(source.path) : source.path;
    const std::string name =
        !source.path.empty() ? source.path.string() : std::string("text");
    const bool by_itself = strands || (cache && file.empty());
    const std::filesystem::path folder =
        source.folder.empty() ? source.path.parent_path() : source.folder;
    TomlTable toml = source.text ? TomlTable::from_text(*source.text, name, folder)
                     : by_itself ? TomlTable::from_text("", name)
                                 : TomlTable::from_file(file);
    for (const GroomParameter& parameter : source.parameters) {
        if (parameter.text) {
            toml.lay_over(parameter.name, *parameter.text);
        } else {
            toml.lay_over(parameter.name, parameter.number);
        }
    }
    Groom out = read_groom(toml, by_itself || source.text ? name : file.string());
    for (const std::string_view key : kOthersTables) toml.leave(key);
    toml.leave("motion");
    toml.finish();
    if (by_itself) {
        out.strands_file = source.path;
    } else if (cache) {
        out.guides_file = source.path;
    }
    return out;
}

}  // namespace lancret
