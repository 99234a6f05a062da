#include "guides/guide_cache.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "guides/guide_cache_hdf5.h"

namespace lancret {

using namespace hdf5;

namespace {

constexpr hsize_t kAny = 0;  ///< a size that is not known beforehand
constexpr double kOrthonormal = 1e-6;
/// The most that deflate, HDF5's compression, can make of a byte.
constexpr double kMostCompression = 1032;

struct Reader {
    const std::filesystem::path& path;
    hid_t file;

    Handle open_attribute(const char* name) const {
        Handle attribute(H5Aopen(file, name, H5P_DEFAULT), H5Aclose);
        if (!attribute.good()) fail(path, fmt::format("no attribute '{}'", name));
        const Handle space(H5Aget_space(attribute), H5Sclose);
        if (H5Sget_simple_extent_npoints(space) != 1) {
            fail(path, fmt::format("attribute '{}' is not a single value", name));
        }
        return attribute;
    }
    template <class T>
    T number(const char* name, hid_t native, H5T_class_t expected) const {
        const Handle attribute = open_attribute(name);
        const Handle type(H5Aget_type(attribute), H5Tclose);
        T value{};
        if (H5Tget_class(type) != expected || H5Aread(attribute, native, &value) < 0) {
            fail(path, fmt::format("attribute '{}' is not {}", name,
                                   expected == H5T_INTEGER ? "an integer" : "a float"));
        }
        return value;
    }
    /// A string of fixed length, as Lancret writes it, or of variable length, as h5py
    /// does.
    std::string text(const char* name) const {
        const Handle attribute = open_attribute(name);
        const Handle type(H5Aget_type(attribute), H5Tclose);
        if (H5Tget_class(type) != H5T_STRING) {
            fail(path, fmt::format("attribute '{}' is not a string", name));
        }
        const bool variable = H5Tis_variable_str(type) > 0;
        std::string value(variable ? 0 : H5Tget_size(type), '\0');
        char* loose = nullptr;
        if (H5Aread(attribute, type,
                    variable ? static_cast<void*>(&loose) : value.data()) < 0) {
            fail(path, fmt::format("attribute '{}' cannot be read", name));
        }
        if (loose) {
            value = loose;
            H5free_memory(loose);
        }
        return value.substr(0, value.find('\0'));
    }
    /// A dataset of floats of this shape; where a size is kAny it is filled in.
    Handle dataset(const char* name, std::vector<hsize_t>& shape) const {
        Handle data(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
        if (!data.good()) fail(path, fmt::format("no dataset '{}'", name));
        const Handle type(H5Dget_type(data), H5Tclose),
            space(H5Dget_space(data), H5Sclose);
        if (H5Tequal(type, H5T_IEEE_F64LE) <= 0 && H5Tequal(type, H5T_IEEE_F32LE) <= 0) {
            fail(path,
                 fmt::format("dataset '{}' does not hold 32- or 64-bit floats", name));
        }
        const int rank = H5Sget_simple_extent_ndims(space);
        if (rank != int(shape.size())) {
            fail(path, fmt::format("dataset '{}' has {} dimensions, expected {}", name,
                                   rank, shape.size()));
        }
        std::vector<hsize_t> found(shape.size());
        H5Sget_simple_extent_dims(space, found.data(), nullptr);
        double bytes = double(H5Tget_size(type));
        for (std::size_t i = 0; i < shape.size(); ++i) {
            const bool fits = shape[i] == kAny ? found[i] > 0 && found[i] <= 0x7fffffff
                                               : found[i] == shape[i];
            if (!fits) {
                fail(path,
                     fmt::format("dataset '{}' has the shape [{}], expected [{}] (0 "
                                 "is any number from 1)",
                                 name, fmt::join(found, ", "), fmt::join(shape, ", ")));
            }
            bytes *= double(found[i]);
        }
        // A shape costs nothing to claim: it must have its bytes before memory is asked
        // for.
        if (double(H5Dget_storage_size(data)) * kMostCompression < bytes) {
            fail(path, fmt::format("dataset '{}' is shorter than its shape", name));
        }
        shape = found;
        return data;
    }
    /// The block of size `count` at `start`, all finite.
    std::vector<double> read(const char* name, const Handle& data,
                             const std::vector<hsize_t>& start,
                             const std::vector<hsize_t>& count) const {
        std::size_t size = 1;
        for (const hsize_t n : count) size *= n;
        std::vector<double> values(size);
        const Handle space(H5Dget_space(data), H5Sclose);
        const Handle memory(H5Screate_simple(int(count.size()), count.data(), nullptr),
                            H5Sclose);
        if (H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr,
                                count.data(), nullptr) < 0 ||
            H5Dread(data, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data()) <
                0) {
            fail(path, fmt::format("dataset '{}' cannot be read", name));
        }
        const auto bad = std::find_if_not(values.begin(), values.end(),
                                          [](double x) { return std::isfinite(x); });
        if (bad != values.end()) {
            fail(path,
                 fmt::format("dataset '{}' is not finite at number {} of those read",
                             name, bad - values.begin()));
        }
        return values;
    }
};

Handle open_file(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        fail(path, std::filesystem::exists(path, error) ? "not a regular file"
                                                        : "there is no such file");
    }
    Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (!file.good()) fail(path, "not an HDF5 file, or a broken one");
    return file;
}

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

    std::vector<hsize_t> shape{kAny, kAny, kAny, 3};
    reader.dataset(kCurvatures, shape);
    info.frames = int(shape[0]);
    info.guides = shape[1];
    info.segments = int(shape[2]);
    std::vector<hsize_t> positions{shape[0], shape[1], 3},
        frames{shape[0], shape[1], 3, 3}, lengths{shape[1], shape[2]};
    reader.dataset(kPositions, positions);
    reader.dataset(kFrames, frames);
    reader.dataset(kLengths, lengths);
    return info;
}

}  // namespace

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
            "read_guide_cache: frame {} of a cache of {}", frame, info.frames));
    }
    const auto read = [&](const char* name, std::vector<hsize_t> shape, bool of_frame) {
        std::vector<hsize_t> start(shape.size(), 0), count = shape;
        if (of_frame) {
            start[0] = hsize_t(frame);
            count[0] = 1;
        }
        return reader.read(name, reader.dataset(name, shape), start, count);
    };
    const auto frames = hsize_t(info.frames), segments = hsize_t(info.segments);
    const hsize_t guides = info.guides;

    Guides out;
    out.segments = info.segments;
    const auto positions = read(kPositions, {frames, guides, 3}, true);
    const auto rotations = read(kFrames, {frames, guides, 3, 3}, true);
    const auto curvatures = read(kCurvatures, {frames, guides, segments, 3}, true);
    out.segment_lengths = read(kLengths, {guides, segments}, false);
    for (std::size_t i = 0; i < out.segment_lengths.size(); ++i) {
        if (!(out.segment_lengths[i] > 0)) {
            fail(path, fmt::format(
                           "dataset '{}' is {} at guide {}, segment {}, expected a "
                           "length above 0",
                           kLengths, out.segment_lengths[i], i / segments, i % segments));
        }
    }
    for (std::size_t g = 0; g < guides; ++g) {
        out.root_positions.emplace_back(Vec3::Map(&positions[3 * g]));
        Mat3 m;
        for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = rotations[9 * g + std::size_t(i)];
        if (!((m.transpose() * m - Mat3::Identity()).cwiseAbs().maxCoeff() <=
              kOrthonormal) ||
            m.determinant() < 0) {
            fail(path, fmt::format("dataset '{}' is not a rotation at frame {}, guide {}",
                                   kFrames, frame, g));
        }
        out.root_frames.push_back(m);
    }
    out.curvatures.reserve(guides * segments);
    for (std::size_t i = 0; i < guides * segments; ++i) {
        out.curvatures.emplace_back(Vec3::Map(&curvatures[3 * i]));
    }
    return out;
}

}  // namespace lancret
