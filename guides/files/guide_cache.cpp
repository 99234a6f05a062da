#include "guides/files/guide_cache.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "guides/files/guide_cache_reader.h"

namespace lancret {

using namespace hdf5;

namespace {

constexpr int kMaxFrame = std::numeric_limits<int>::max();

GuideCacheInfo read_info(const Reader& reader) {
    const std::string format = reader.text("format");
    if (format != kFormat) {
        fail(reader.path,
             fmt::format("attribute 'format' is '{}', expected '{}'", format, kFormat));
    }
    const int version = reader.number<int>("version", H5T_NATIVE_INT, H5T_INTEGER);
    if (version != kVersion) {
        fail(reader.path,
             fmt::format("attribute 'version' is {}, expected {}", version, kVersion));
    }
    if (const std::string units = reader.text("units"); units != kUnits) {
        fail(reader.path,
             fmt::format("attribute 'units' is '{}', expected '{}'", units, kUnits));
    }
    GuideCacheInfo info;
    info.frames_per_second =
        reader.number<double>("frames_per_second", H5T_NATIVE_DOUBLE, H5T_FLOAT);
    if (!(info.frames_per_second > 0) || !std::isfinite(info.frames_per_second)) {
        fail(reader.path, fmt::format("attribute 'frames_per_second' is {}, expected a "
                                      "number above 0",
                                      info.frames_per_second));
    }
    info.first_frame = reader.number<int>("first_frame", H5T_NATIVE_INT, H5T_INTEGER);
    info.groom = reader.text("groom");
    info.has_rest = reader.has(kRest);
    info.has_restart = reader.has(kRestart);

    std::vector<hsize_t> shape{kAny, kAny, kAny, 3};
    reader.dataset(kCurvatures, shape);
    info.frames = int(shape[0]);
    if (std::int64_t(info.first_frame) + info.frames > std::int64_t(kMaxFrame) + 1) {
        fail(reader.path, fmt::format("attribute 'first_frame' is {}, too large for {} "
                                      "frames",
                                      info.first_frame, info.frames));
    }
    info.guides = shape[1];
    info.segments = int(shape[2]);
    std::vector<hsize_t> positions{shape[0], shape[1], 3},
        frames{shape[0], shape[1], 3, 3}, lengths{shape[1], shape[2]};
    reader.dataset(kPositions, positions);
    reader.dataset(kFrames, frames);
    reader.dataset(kLengths, lengths);
    return info;
}

/// The guides of `frame`; of the rest pose if it is nullopt.
Guides guides_of(const Reader& reader, const GuideCacheInfo& info,
                 std::optional<int> frame) {
    const auto segments = hsize_t(info.segments);
    const hsize_t guides = info.guides;
    const std::string prefix = frame ? "" : kRest;
    const auto read = [&](const char* name, std::vector<hsize_t> shape) {
        std::vector<hsize_t> start(shape.size(), 0), count = shape;
        if (frame) {
            shape.insert(shape.begin(), hsize_t(info.frames));
            start.insert(start.begin(), hsize_t(*frame));
            count.insert(count.begin(), 1);
        }
        const std::string full = prefix + name;
        return reader.read(full.c_str(), reader.dataset(full.c_str(), shape), start,
                           count);
    };
    Guides out;
    out.segments = info.segments;
    const auto positions = read(kPositions, {guides, 3});
    const auto rotations = read(kFrames, {guides, 3, 3});
    const auto curvatures = read(kCurvatures, {guides, segments, 3});
    std::vector<hsize_t> shape{guides, segments};
    out.segment_lengths =
        reader.read(kLengths, reader.dataset(kLengths, shape), {0, 0}, shape);
    for (std::size_t i = 0; i < out.segment_lengths.size(); ++i) {
        if (!(out.segment_lengths[i] > 0)) {
            fail(reader.path,
                 fmt::format("dataset '{}' is {} at guide {}, segment {}, expected a "
                             "length above 0",
                             kLengths, out.segment_lengths[i], i / segments,
                             i % segments));
        }
    }
    for (std::size_t g = 0; g < guides; ++g) {
        out.root_positions.emplace_back(Vec3::Map(&positions[3 * g]));
        Mat3 m;
        for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = rotations[9 * g + std::size_t(i)];
        if (!is_cache_rotation(m)) {
            fail(reader.path,
                 fmt::format("dataset '{}{}' is not a rotation at {}guide {}", prefix,
                             kFrames, frame ? fmt::format("frame {}, ", *frame) : "", g));
        }
        out.root_frames.push_back(m);
    }
    out.curvatures.reserve(guides * segments);
    for (std::size_t i = 0; i < guides * segments; ++i) {
        out.curvatures.emplace_back(Vec3::Map(&curvatures[3 * i]));
    }
    return out;
}

}  // namespace

bool is_cache_rotation(const Mat3& m) {
    constexpr double kOrthonormal = 1e-6;
    return (m.transpose() * m - Mat3::Identity()).cwiseAbs().maxCoeff() <= kOrthonormal &&
           m.determinant() > 0;
}

GuideCacheInfo guide_cache_info(const std::filesystem::path& path) {
    const Session session;
    const Handle file = open_file(path);
    return read_info({path, file});
}

Guides read_guide_cache(const std::filesystem::path& path, int frame) {
    const Session session;
    const Handle file = open_file(path);
    const Reader reader{path, file};
    const GuideCacheInfo info = read_info(reader);
    if (frame < 0 || frame >= info.frames) {
        throw std::invalid_argument(fmt::format(
            "read_guide_cache: frame {} of a cache of {} frames", frame, info.frames));
    }
    return guides_of(reader, info, frame);
}

Guides read_rest_guides(const std::filesystem::path& path) {
    const Session session;
    const Handle file = open_file(path);
    const Reader reader{path, file};
    const GuideCacheInfo info = read_info(reader);
    return guides_of(reader, info, info.has_rest ? std::nullopt : std::optional(0));
}

}  // namespace lancret
