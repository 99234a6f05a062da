#include "guides/files/mitsuba_file.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <ostream>
#include <stdexcept>

#include "guides/base/atomic_file.h"
#include "guides/base/errors.h"

namespace lancret {

namespace {

/// Size of the pieces in which text is written: a million strands are a gigabyte.
constexpr std::size_t kPiece = 1 << 20;

bool is_finite(const Point4f& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) &&
           std::isfinite(p.w);
}

}  // namespace

void write_mitsuba(const std::filesystem::path& path, std::span<const Point4f> points,
                   std::size_t points_per_strand) {
    if (points_per_strand < 4 || points.empty() ||
        points.size() % points_per_strand != 0) {
        throw std::invalid_argument(
            fmt::format("write_mitsuba: expected whole strands of four or more points, "
                        "but there are {} points "
                        "and {} per strand",
                        points.size(), points_per_strand));
    }
    write_beside_and_rename(path, [&](std::ostream& stream) {
        fmt::memory_buffer text;
        const auto flush = [&] {
            stream.write(text.data(), std::streamsize(text.size()));
            text.clear();
        };
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Point4f& p = points[i];
            if (!is_finite(p)) {
                throw InputError(fmt::format("{}: strand {}, point {} is not finite",
                                             path.string(), i / points_per_strand,
                                             i % points_per_strand));
            }
            if (i > 0 && i % points_per_strand == 0) text.push_back('\n');
            fmt::format_to(std::back_inserter(text), "{} {} {} {}\n", p.x, p.y, p.z, p.w);
            if (text.size() > kPiece) flush();
        }
        flush();
    });
}

}  // namespace lancret
