#include "guides/files/hair_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>

#include "guides/base/coordinates.h"
#include "guides/base/errors.h"
#include "guides/files/hair_header.h"

namespace lancret {

namespace {

using namespace hair;

/// An open file that keeps its offset for errors.
class HairReader {
  public:
    explicit HairReader(const std::filesystem::path& path)
        : name_(path.string()), stream_(path, std::ios::binary) {
        std::error_code error;
        if (!std::filesystem::exists(path, error)) {
            throw InputError(name_ + ": there is no such file");
        }
        if (!std::filesystem::is_regular_file(path, error)) {
            throw InputError(name_ + ": not a regular file");
        }
        size_ = std::filesystem::file_size(path, error);
        if (error || !stream_) throw InputError(name_ + ": cannot be read");
    }

    [[noreturn]] void fail(std::uint64_t byte, std::string_view what) const {
        throw InputError(fmt::format("{}:byte {}: {}", name_, byte, what));
    }

    template <class T>
    void read(T* values, std::uint64_t count) {
        stream_.read(reinterpret_cast<char*>(values), std::streamsize(count * sizeof(T)));
        if (!stream_) fail(offset_, "the file ends within an array");
        offset_ += count * sizeof(T);
    }

    /// The next array, of `count` elements; empty if its flag is not set.
    template <class T>
    std::vector<T> array(std::uint32_t flags, ArrayFlag flag, std::uint64_t count) {
        if (!(flags & flag)) return {};
        std::vector<T> values(count);
        read(values.data(), count);
        return values;
    }

    const std::string& name() const { return name_; }
    std::uint64_t size() const { return size_; }
    std::uint64_t offset() const { return offset_; }

  private:
    std::string name_;
    std::ifstream stream_;
    std::uint64_t size_ = 0, offset_ = 0;
};

Header read_header(HairReader& file) {
    if (file.size() < sizeof(Header)) {
        file.fail(file.size(), fmt::format("the file ends within its header, expected {} "
                                           "bytes",
                                           sizeof(Header)));
    }
    Header header;
    file.read(&header, 1);
    const std::string_view magic(header.magic, 4);
    if (magic == "hair") {
        file.fail(0, "the signature is 'hair' in lower case, expected 'HAIR'");
    }
    if (magic != "HAIR") file.fail(0, "not a .hair file: expected the signature 'HAIR'");
    if (header.strands == 0) file.fail(4, "no strands, expected at least one");
    if (!(header.flags & kPoints)) {
        file.fail(12, fmt::format("flags {:#x}: no points array (2), which is required",
                                  header.flags));
    }
    const float defaults[] = {header.default_thickness, header.default_transparency,
                              header.default_colour[0], header.default_colour[1],
                              header.default_colour[2]};
    for (std::size_t i = 0; i < std::size(defaults); ++i) {
        if (!std::isfinite(defaults[i])) {
            file.fail(20 + 4 * i,
                      fmt::format("the default of {} is {}, expected a finite "
                                  "number",
                                  i == 0   ? "thickness"
                                  : i == 1 ? "transparency"
                                           : "colour",
                                  defaults[i]));
        }
    }
    if (header.default_thickness < 0) {
        file.fail(20, fmt::format("the default thickness is {}, expected at least 0",
                                  header.default_thickness));
    }
    return header;
}

/// The file size that the header implies; below 2^40, so that no sum overflows.
std::uint64_t bytes_expected(const Header& header) {
    constexpr std::uint64_t kBytesPerPoint[] = {0, 12, 4, 4, 12, 8};
    std::uint64_t bytes = sizeof(Header);
    if (header.flags & kSegments) bytes += 2 * std::uint64_t(header.strands);
    for (int bit = 0; bit < 6; ++bit) {
        if (header.flags >> bit & 1) bytes += kBytesPerPoint[bit] * header.points;
    }
    return bytes;
}

void check_sizes(const HairReader& file, const Header& header, HairReport& report) {
    const std::uint64_t expected = bytes_expected(header);
    if (file.size() < expected) {
        file.fail(file.size(),
                  fmt::format("the file ends here, but {} strands and {} points with "
                              "flags {:#x} need {} bytes",
                              header.strands, header.points, header.flags, expected));
    }
    if (header.flags & ~kKnownFlags) {
        report.warnings.push_back(
            fmt::format("{}:byte 12: unknown array flags {:#x} are ignored", file.name(),
                        header.flags & ~kKnownFlags));
    }
    if (file.size() > expected) {
        report.warnings.push_back(
            fmt::format("{}:byte {}: {} bytes after the last array "
                        "are ignored",
                        file.name(), expected, file.size() - expected));
    }
    const std::uint64_t default_points =
        header.strands * (std::uint64_t(header.default_segments) + 1);
    if (!(header.flags & kSegments) && default_points != header.points) {
        file.fail(8, fmt::format("{} points, but {} strands of {} segments each have {}",
                                 header.points, header.strands, header.default_segments,
                                 default_points));
    }
}

/// The first point of each strand, then the end.
std::vector<std::uint32_t> read_first(HairReader& file, const Header& header) {
    const std::uint64_t start = file.offset();
    const auto segments =
        file.array<std::uint16_t>(header.flags, kSegments, header.strands);
    // Without the array, check_sizes has validated the sum.
    std::vector<std::uint32_t> first(std::size_t(header.strands) + 1, 0);
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < header.strands; ++i) {
        sum += (segments.empty() ? header.default_segments : segments[i]) + 1ull;
        if (sum > header.points) break;
        first[i + 1] = std::uint32_t(sum);
    }
    if (sum != header.points) {
        file.fail(start, fmt::format("the strands have {} points or more (segments + 1 "
                                     "each), but the header has {}",
                                     sum, header.points));
    }
    return first;
}

std::string place_of(const Strands& strands, std::size_t point) {
    const auto after = std::upper_bound(strands.first.begin(), strands.first.end(),
                                        std::uint32_t(point));
    const auto strand = std::size_t(after - strands.first.begin()) - 1;
    return fmt::format("strand {}, point {}", strand, point - strands.first[strand]);
}

/// Fails at the first value that is not `good` of an array that starts at byte `start`.
template <class T, class Good>
void check_values(const HairReader& file, std::uint64_t start, const Strands& strands,
                  const std::vector<T>& values, std::string_view what, Good good) {
    const auto bad = std::find_if_not(values.begin(), values.end(), good);
    if (bad == values.end()) return;
    const auto i = std::size_t(bad - values.begin());
    file.fail(start + i * sizeof(T), fmt::format("{}: {}", place_of(strands, i), what));
}

/// Removes the values of the strands of a single point.
template <class T>
void keep_long(const std::vector<std::uint32_t>& first, std::vector<T>& values) {
    if (values.empty()) return;
    auto end = values.begin();
    for (std::size_t i = 0; i + 1 < first.size(); ++i) {
        if (first[i + 1] - first[i] < 2) continue;
        end = std::move(values.begin() + first[i], values.begin() + first[i + 1], end);
    }
    values.erase(end, values.end());
}

void drop_single_points(const HairReader& file, Strands& strands, HairReport& report) {
    std::vector<std::uint32_t> kept{0};
    for (std::size_t i = 0; i < strands.size(); ++i) {
        const std::uint32_t points = strands.first[i + 1] - strands.first[i];
        if (points > 1) {
            kept.push_back(kept.back() + points);
        } else {
            report.dropped.push_back(std::uint32_t(i));
        }
    }
    report.dropped_strands = strands.first.size() - kept.size();
    if (report.dropped_strands == 0) return;
    if (kept.size() == 1) {
        file.fail(4, fmt::format("each of the {} strands is a single point, expected at "
                                 "least one strand of two or more",
                                 strands.size()));
    }
    keep_long(strands.first, strands.points);
    keep_long(strands.first, strands.thickness);
    keep_long(strands.first, strands.transparency);
    keep_long(strands.first, strands.colours);
    keep_long(strands.first, strands.uvs);
    strands.first = std::move(kept);
    report.warnings.push_back(fmt::format("{}: {} strands of a single point were dropped",
                                          file.name(), report.dropped_strands));
}

}  // namespace

Strands read_hair(const std::filesystem::path& path, HairReport* report) {
    HairReport unused;
    HairReport& findings = report ? *report : unused;
    findings = {};
    HairReader file(path);
    const Header header = read_header(file);
    check_sizes(file, header, findings);
    findings.text.assign(header.text, strnlen(header.text, sizeof header.text));

    Strands strands;
    strands.default_thickness = header.default_thickness;
    strands.default_transparency = header.default_transparency;
    strands.default_colour = Vec3f::Map(header.default_colour);
    strands.first = read_first(file, header);

    const auto finite = [](const auto& v) { return v.allFinite(); };
    std::uint64_t start = file.offset();
    strands.points = file.array<Vec3f>(header.flags, kPoints, header.points);
    check_values(file, start, strands, strands.points,
                 fmt::format("invalid position, expected finite coordinates within {:g}",
                             kLargestCoordinate),
                 is_place);
    start = file.offset();
    strands.thickness = file.array<float>(header.flags, kThickness, header.points);
    check_values(file, start, strands, strands.thickness,
                 "the thickness is not a finite number of at least 0",
                 [](float t) { return t >= 0 && std::isfinite(t); });
    start = file.offset();
    strands.transparency = file.array<float>(header.flags, kTransparency, header.points);
    check_values(file, start, strands, strands.transparency,
                 "the transparency is not finite",
                 [](float t) { return std::isfinite(t); });
    start = file.offset();
    strands.colours = file.array<Vec3f>(header.flags, kColours, header.points);
    check_values(file, start, strands, strands.colours, "the colour is not finite",
                 finite);
    start = file.offset();
    strands.uvs = file.array<Vec2f>(header.flags, kUvs, header.points);
    check_values(file, start, strands, strands.uvs, "the UV is not finite", finite);

    drop_single_points(file, strands, findings);
    return strands;
}

}  // namespace lancret
