#include "procedural/abi/source.h"

#include <fmt/format.h>

#include <bit>
#include <limits>
#include <system_error>

#include "guides/base/cancel.h"
#include "guides/base/coordinates.h"
#include "guides/base/errors.h"
#include "procedural/abi/file_stamp.h"
#include "procedural/chunk/chunks.h"

namespace lancret::abi {

namespace {

constexpr std::size_t kMaxParameters = 1 << 16;
constexpr std::uint32_t kMaxChunkStrands = 1'000'000;
constexpr int kMaxStampedFrames = 1000;

std::vector<Vec3f> positions_of(const float* from, std::size_t count, const char* what) {
    std::vector<Vec3f> out(count);
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = Vec3f(from[3 * i], from[3 * i + 1], from[3 * i + 2]);
        if (is_place(out[i])) continue;
        throw InputError(fmt::format(
            "{}: point {} is at ({}, {}, {}), expected finite coordinates up to {:g}",
            what, i, out[i].x(), out[i].y(), out[i].z(), kLargestCoordinate));
    }
    return out;
}

std::shared_ptr<const Strands> copied(const lancret_strands* given) {
    const auto in = read_sized(given, "lancret_strands: null, or invalid size");
    require(in.strands > 0 && in.counts && in.points,
            "lancret_strands: no strands, or an array is null");
    require(in.basis >= LANCRET_LINEAR && in.basis <= LANCRET_CATMULL_ROM,
            "lancret_strands: unsupported basis");
    auto out = std::make_shared<Strands>();
    out->basis = in.basis == LANCRET_BSPLINE ? Basis::bspline : Basis::catmull_rom;
    out->first.reserve(std::size_t(in.strands) + 1);
    std::uint64_t points = 0;
    const lancret_u32 fewest = in.basis == LANCRET_BSPLINE ? 4 : 2;
    for (std::size_t i = 0; i < in.strands; ++i) {
        if (in.counts[i] < fewest) {
            throw InputError(
                fmt::format("strands: strand {} has {} points, expected {} or more", i,
                            in.counts[i], fewest));
        }
        points += in.counts[i];
        require(points <= std::numeric_limits<std::int32_t>::max(),
                "lancret_strands: more than 2^31 points");
        out->first.push_back(std::uint32_t(points));
    }
    out->points = positions_of(in.points, points, "strands");
    return out;
}

std::shared_ptr<const TriangleMesh> copied(const lancret_mesh* given) {
    const auto in = read_sized(given, "lancret_mesh: null, or invalid size");
    require(in.vertices > 0 && in.triangles > 0 && in.positions && in.corners,
            "lancret_mesh: no triangles, or an array is null");
    auto out = std::make_shared<TriangleMesh>();
    out->positions = positions_of(in.positions, in.vertices, "scalp");
    out->triangles.resize(in.triangles);
    for (std::size_t t = 0; t < in.triangles; ++t) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t vertex = in.corners[3 * t + c];
            if (vertex >= in.vertices) {
                throw InputError(fmt::format(
                    "scalp: triangle {} has a corner at vertex {}, expected below {}", t,
                    vertex, in.vertices));
            }
            out->triangles[t][c] = vertex;
        }
    }
    if (!in.uvs) return out;
    out->uvs.resize(in.triangles);
    for (std::size_t t = 0; t < in.triangles; ++t) {
        for (std::size_t c = 0; c < 3; ++c) {
            const Vec2f uv(in.uvs[6 * t + 2 * c], in.uvs[6 * t + 2 * c + 1]);
            if (!uv.allFinite()) {
                throw InputError(
                    fmt::format("scalp: triangle {} has a UV that is not finite", t));
            }
            out->uvs[t][c] = uv;
        }
    }
    return out;
}

/// Prefixed with its length, so that two adjacent texts cannot be read as two others.
void add(std::string& key, std::string_view text) {
    fmt::format_to(std::back_inserter(key), "{}:{};", text.size(), text);
}

void add_file(std::string& key, const std::filesystem::path& file) {
    std::error_code ignored;
    add(key, file.empty() ? "" : std::filesystem::absolute(file, ignored).string());
    if (file.empty()) return;
    const FileStamp stamp = stamp_of(file);
    add(key, fmt::format("{} {}", stamp.size, stamp.time.time_since_epoch().count()));
}

}  // namespace

Source read_source(const lancret_source* given) {
    const auto in = read_sized(given, "lancret_source: null, or invalid size");
    require(in.path || in.text || in.strands, "lancret_source: no path, text or strands");
    require(!in.path || *in.path, "lancret_source: path is empty");
    require(in.parameter_count <= kMaxParameters,
            "lancret_source: more than 65536 parameters");
    require(in.parameters || in.parameter_count == 0,
            "lancret_source: parameters is null");
    require(in.chunk_strands <= kMaxChunkStrands,
            "lancret_source: chunk_strands is above 1000000");
    Source out;
    if (in.path) out.settings.path = in.path;
    if (in.text) out.settings.text = in.text;
    if (in.folder) out.settings.folder = in.folder;
    for (std::size_t i = 0; i < in.parameter_count; ++i) {
        const lancret_parameter& p = in.parameters[i];
        require(p.name, "lancret_parameter: name is null");
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

SourcedGroom read_groom(const Source& source) {
    SourcedGroom out = read_groom_source(source.settings);
    for (const char* table :
         {"camera", "light", "material", "render", "dynamics", "colliders"}) {
        out.toml.leave(table);
    }
    out.toml.finish();
    return out;
}

std::optional<std::string> key_of(const Source& source, const SourcedGroom& sourced) {
    const GroomSource& s = source.settings;
    if (s.strands || s.scalp) return std::nullopt;
    std::string key;
    add_file(key, s.path);
    // Its text as well, which may have changed without its size and time.
    add(key, sourced.text);
    std::error_code ignored;
    const std::filesystem::path folder = s.folder.empty() ? "." : s.folder;
    add(key, std::filesystem::absolute(folder, ignored).string());
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
        1 + (std::int64_t(files.last) - files.first) / kMaxStampedFrames;
    for (std::int64_t f = files.first; f <= files.last; f += step) {
        add_file(key, frame_path(files.pattern, int(f)));
        stop_if_cancelled();
    }
    return key;
}

}  // namespace lancret::abi
