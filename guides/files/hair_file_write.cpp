#include "guides/files/hair_file_write.h"

#include <fmt/format.h>

#include <cstring>
#include <limits>
#include <ostream>

#include "guides/base/atomic_file.h"
#include "guides/base/errors.h"
#include "guides/files/hair_header.h"

namespace lancret {

namespace {

using namespace hair;

std::vector<std::uint16_t> segments_of(const std::filesystem::path& path,
                                       const Strands& strands) {
    std::vector<std::uint16_t> segments(strands.size());
    for (std::size_t i = 0; i < strands.size(); ++i) {
        require(strands.first[i + 1] > strands.first[i] + std::uint64_t(1),
                "write_hair: a strand has fewer than two points");
        const std::uint32_t count = strands.first[i + 1] - strands.first[i] - 1;
        if (count > std::numeric_limits<std::uint16_t>::max()) {
            throw InputError(fmt::format(
                "{}: strand {} has {} segments, but a .hair file stores at most 65535",
                path.string(), i, count));
        }
        segments[i] = std::uint16_t(count);
    }
    return segments;
}

template <class T>
void put(std::ostream& stream, const std::vector<T>& values) {
    stream.write(reinterpret_cast<const char*>(values.data()),
                 std::streamsize(values.size() * sizeof(T)));
}

}  // namespace

void write_hair(const std::filesystem::path& path, const Strands& strands) {
    const std::size_t points = strands.points.size();
    const auto none_or_all = [&](const auto& v) {
        return v.empty() || v.size() == points;
    };
    require(strands.first.size() > 1, "write_hair: expected at least one strand");
    require(strands.first.front() == 0 && strands.first.back() == points,
            "write_hair: `first` does not span the points");
    require(none_or_all(strands.thickness) && none_or_all(strands.transparency) &&
                none_or_all(strands.colours) && none_or_all(strands.uvs),
            "write_hair: expected one attribute per point or none");
    const std::vector<std::uint16_t> segments = segments_of(path, strands);

    Header header{};
    std::memcpy(header.magic, "HAIR", 4);
    header.strands = std::uint32_t(strands.size());
    header.points = std::uint32_t(points);
    header.flags = kSegments | kPoints;
    if (!strands.thickness.empty()) header.flags |= kThickness;
    if (!strands.transparency.empty()) header.flags |= kTransparency;
    if (!strands.colours.empty()) header.flags |= kColours;
    if (!strands.uvs.empty()) header.flags |= kUvs;
    header.default_segments = segments.front();
    header.default_thickness = strands.default_thickness;
    header.default_transparency = strands.default_transparency;
    Vec3f::Map(header.default_colour) = strands.default_colour;
    std::memcpy(header.text, "Lancret", 7);

    write_beside_and_rename(path, [&](std::ostream& stream) {
        stream.write(reinterpret_cast<const char*>(&header), sizeof header);
        put(stream, segments);
        put(stream, strands.points);
        put(stream, strands.thickness);
        put(stream, strands.transparency);
        put(stream, strands.colours);
        put(stream, strands.uvs);
    });
}

}  // namespace lancret
