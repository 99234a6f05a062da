#pragma once
// Reading from the guide cache: every name, type, shape and number is validated before it
// is used. Only guide_cache*.cpp may include it.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "guides/files/guide_cache_hdf5.h"

namespace lancret::hdf5 {

inline constexpr hsize_t kAny = 0;  ///< any size from 1
inline constexpr hsize_t kAnyOrNone = ~hsize_t(0);
/// Maximum ratio of deflate, HDF5's compression.
inline constexpr double kMaxCompression = 1032;

/// Reads from a file or from a group of it.
struct Reader {
    const std::filesystem::path& path;
    hid_t file;

    /// Whether an object of this name exists.
    bool has(const char* name) const {
        const htri_t exists = H5Lexists(file, name, H5P_DEFAULT);
        if (exists < 0) fail(path, "not an HDF5 file, or a damaged one");
        return exists > 0;
    }
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
    /// A string of fixed length, as Lancret writes, or of variable length, as h5py
    /// writes.
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
    /// A dataset of floats of this shape. Sizes that are kAny or kAnyOrNone are filled
    /// in.
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
            const bool any = shape[i] == kAny || shape[i] == kAnyOrNone;
            const bool fits =
                any ? found[i] <= 0x7fffffff && (found[i] > 0 || shape[i] == kAnyOrNone)
                    : found[i] == shape[i];
            if (!fits) {
                fail(path,
                     fmt::format("dataset '{}' has the shape [{}], expected [{}] (0 "
                                 "stands for any number from 1)",
                                 name, fmt::join(found, ", "), fmt::join(shape, ", ")));
            }
            bytes *= double(found[i]);
        }
        // Any file may claim a large shape: it must store the bytes before memory is
        // allocated.
        if (double(H5Dget_storage_size(data)) * kMaxCompression < bytes) {
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
            fail(path, fmt::format("dataset '{}': value {} of those read is not finite",
                                   name, bad - values.begin()));
        }
        return values;
    }
};

inline Handle open_file(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        fail(path, std::filesystem::exists(path, error) ? "not a regular file"
                                                        : "there is no such file");
    }
    Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (!file.good()) fail(path, "not an HDF5 file, or a damaged one");
    return file;
}

}  // namespace lancret::hdf5
