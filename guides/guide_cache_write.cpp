#include <stdexcept>
#include <string>
#include <vector>

#include "guides/atomic_file.h"
#include "guides/guide_cache.h"
#include "guides/guide_cache_hdf5.h"

namespace lancret {

using namespace hdf5;

namespace {

struct Writer {
    const std::filesystem::path& path;  ///< as the user knows it
    hid_t file;

    void check(bool good) const {
        if (!good) fail(path, "cannot be written: HDF5 reports a failure");
    }
    void attribute(const char* name, hid_t type, const void* value) const {
        const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
        const Handle made(H5Acreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT),
                          H5Aclose);
        check(made.good() && H5Awrite(made, type, value) >= 0);
    }
    void attribute(const char* name, std::string_view text) const {
        const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
        // A string type has at least one byte.
        const std::string padded =
            text.empty() ? std::string(1, '\0') : std::string(text);
        check(H5Tset_size(type, padded.size()) >= 0 &&
              H5Tset_cset(type, H5T_CSET_UTF8) >= 0 &&
              H5Tset_strpad(type, H5T_STR_NULLPAD) >= 0);
        attribute(name, type, padded.data());
    }
    /// A new dataset in chunks of `chunk`.
    Handle dataset(const char* name, const std::vector<hsize_t>& shape,
                   const std::vector<hsize_t>& chunk) const {
        const Handle space(H5Screate_simple(int(shape.size()), shape.data(), nullptr),
                           H5Sclose);
        const Handle layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
        // HDF5 takes chunks below 4 GB alone; contiguous storage has no such end.
        double bytes = sizeof(double);
        for (const hsize_t n : chunk) bytes *= double(n);
        if (bytes < 4e9) {
            H5Pset_chunk(layout, int(chunk.size()), chunk.data());
            H5Pset_fletcher32(layout);
        }
        return {H5Dcreate2(file, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, layout,
                           H5P_DEFAULT),
                H5Dclose};
    }
    /// Writes the block of size `count` at `start`.
    void write(const Handle& into, const std::vector<hsize_t>& start,
               const std::vector<hsize_t>& count, const double* values) const {
        check(into.good());
        const Handle space(H5Dget_space(into), H5Sclose);
        const Handle memory(H5Screate_simple(int(count.size()), count.data(), nullptr),
                            H5Sclose);
        check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr,
                                  count.data(), nullptr) >= 0 &&
              H5Dwrite(into, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values) >= 0);
    }
};

void require(bool holds, const char* what) {
    if (!holds) throw std::invalid_argument(std::string("write_guide_cache: ") + what);
}

/// Matrices row by row: Eigen keeps them column by column.
std::vector<double> rows_of(std::span<const Mat3> frames) {
    std::vector<double> rows;
    rows.reserve(9 * frames.size());
    for (const Mat3& m : frames) {
        for (int r = 0; r < 3; ++r) rows.insert(rows.end(), {m(r, 0), m(r, 1), m(r, 2)});
    }
    return rows;
}

void check_frames(std::span<const Guides> frames) {
    require(!frames.empty(), "there are no frames");
    const std::size_t guides = frames[0].size();
    const int segments = frames[0].segments;
    require(guides > 0 && segments > 0, "there are no guides");
    for (const Guides& frame : frames) {
        require(frame.size() == guides && frame.segments == segments &&
                    frame.root_frames.size() == guides &&
                    frame.curvatures.size() == guides * std::size_t(segments),
                "the frames differ in guides or segments");
        require(frame.segment_lengths == frames[0].segment_lengths &&
                    frame.segment_lengths.size() == frame.curvatures.size(),
                "the frames differ in segment lengths");
    }
}

}  // namespace

void write_guide_cache(const std::filesystem::path& path, const GuideCacheHeader& header,
                       std::span<const Guides> frames) {
    check_frames(frames);
    const hsize_t count = frames.size(), guides = frames[0].size();
    const auto segments = hsize_t(frames[0].segments);

    const Session session;
    PendingFile pending(path);
    // The format of HDF5 1.10 has checksums in all of its structures, and so do chunks
    // (see dataset): damage is found before it is believed.
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_LATEST);
    Handle file(
        H5Fcreate(pending.temporary().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access),
        H5Fclose);
    const Writer writer{path, file};
    writer.check(file.good());
    writer.attribute("format", kFormat);
    writer.attribute("version", H5T_NATIVE_INT, &kVersion);
    writer.attribute("units", kUnits);
    writer.attribute("frames_per_second", H5T_NATIVE_DOUBLE, &header.frames_per_second);
    writer.attribute("first_frame", H5T_NATIVE_INT, &header.first_frame);
    writer.attribute("groom", header.groom);
    {
        const Handle positions =
            writer.dataset(kPositions + 1, {count, guides, 3}, {1, guides, 3});
        const Handle rotations =
            writer.dataset(kFrames + 1, {count, guides, 3, 3}, {1, guides, 3, 3});
        const Handle curvatures = writer.dataset(
            kCurvatures + 1, {count, guides, segments, 3}, {1, guides, segments, 3});
        const Handle lengths =
            writer.dataset(kLengths + 1, {guides, segments}, {guides, segments});
        writer.write(lengths, {0, 0}, {guides, segments},
                     frames[0].segment_lengths.data());
        for (hsize_t f = 0; f < count; ++f) {
            const Guides& frame = frames[f];
            writer.write(positions, {f, 0, 0}, {1, guides, 3},
                         frame.root_positions.data()->data());
            writer.write(rotations, {f, 0, 0, 0}, {1, guides, 3, 3},
                         rows_of(frame.root_frames).data());
            writer.write(curvatures, {f, 0, 0, 0}, {1, guides, segments, 3},
                         frame.curvatures.data()->data());
        }
    }
    // A full disk may show only here.
    writer.check(file.close());
    pending.commit();
}

}  // namespace lancret
