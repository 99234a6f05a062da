#include "procedural/abi/source.h"

#include <fmt/format.h>

#include <bit>
#include <system_error>

#include "guides/base/cancel.h"
#include "procedural/abi/file_stamp.h"
#include "procedural/chunk/chunks.h"

namespace lancret::abi {

namespace {

constexpr std::size_t kMaxParameters = 1 << 16;
constexpr std::uint32_t kMaxChunkStrands = 1'000'000;
constexpr int kMaxFramesLookedAt = 1000;

/// Length first, so that two texts side by side are not taken for two others.
void add(std::string& key, std::string_view text) {
    fmt::format_to(std::back_inserter(key), "{}:{};", text.size(), text);
}

void add_file(std::string& key, const std::filesystem::path& file) {
    std::error_code unknown;  // a file that is not there has no size
    add(key, file.empty() ? "" : std::filesystem::absolute(file, unknown).string());
    if (file.empty()) return;
    const FileStamp stamp = stamp_of(file);
    add(key, fmt::format("{} {}", stamp.size, stamp.time.time_since_epoch().count()));
}

}  // namespace

Source read_source(const lancret_source* given) {
    const auto in = read_sized(given, "lancret_source and its size");
    require(in.path || in.text || in.strands,
            "lancret_source: neither path nor text nor strands");
    require(!in.path || *in.path, "lancret_source: path is empty");
    require(in.parameter_count <= kMaxParameters, "lancret_source: parameter_count");
    require(in.parameters || in.parameter_count == 0, "lancret_source: parameters");
    require(in.chunk_strands <= kMaxChunkStrands, "lancret_source: chunk_strands");
    Source out;
    if (in.path) out.settings.path = in.path;
    if (in.text) out.settings.text = in.text;
    if (in.folder) out.settings.folder = in.folder;
    for (std::size_t i = 0; i < in.parameter_count; ++i) {
        const lancret_parameter& p = in.parameters[i];
        require(p.name, "lancret_parameter: name");
        GroomParameter& to = out.settings.parameters.emplace_back();
        to.name = p.name;
        if (p.text) to.text = p.text;
        to.number = p.number;
    }
    if (in.strands) out.settings.strands = copied(in.strands);
    if (in.scalp) out.settings.scalp = copied(in.scalp);
    out.chunk_strands = in.chunk_strands ? in.chunk_strands : kStrandsPerChunk;
    return out;
}

std::optional<std::string> key_of(const Source& source, const SourcedGroom& sourced) {
    const GroomSource& s = source.settings;
    if (s.strands || s.scalp) return std::nullopt;
    std::string key;
    add_file(key, s.path);
    // Not the file's size and time: it may have changed and kept them.
    add(key, sourced.text);
    std::error_code unknown;
    const std::filesystem::path folder = s.folder.empty() ? "." : s.folder;
    add(key, std::filesystem::absolute(folder, unknown).string());
    for (const GroomParameter& p : s.parameters) {
        add(key, p.name);
        add(key, p.text ? *p.text : "");
        add(key, fmt::format("{} {}", p.text.has_value(),
                             std::bit_cast<std::uint64_t>(p.number)));
    }
    add(key, std::to_string(source.chunk_strands));
    const GroomSettings& groom = sourced.groom;
    for (const std::filesystem::path& file :
         {std::filesystem::path(groom.name), groom.strands_file, groom.guides_file,
          groom.scalp_file, groom.regions.texture, groom.regions.ids}) {
        add_file(key, file);
    }
    const ObjSequence& files = sourced.motion.files;
    if (files.pattern.empty()) return key;
    add(key, files.pattern);
    const std::int64_t step =
        1 + (std::int64_t(files.last) - files.first) / kMaxFramesLookedAt;
    for (std::int64_t f = files.first; f <= files.last; f += step) {
        add_file(key, frame_path(files.pattern, int(f)));
        stop_if_cancelled();
    }
    return key;
}

}  // namespace lancret::abi
