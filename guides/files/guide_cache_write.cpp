#include "guides/files/guide_cache_write.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "guides/base/atomic_file.h"
#include "guides/base/errors.h"
#include "guides/files/guide_cache_hdf5.h"

namespace lancret {

using namespace hdf5;

namespace {

/// Creation properties without a time stamp.
Handle timeless(hid_t kind) {
    Handle out(H5Pcreate(kind), H5Pclose);
    H5Pset_obj_track_times(out, false);
    return out;
}

/// Writes to a file or to a group of it.
struct Writer {
    const std::filesystem::path& path;  ///< the target, for errors
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
        const Handle layout = timeless(H5P_DATASET_CREATE);
        // HDF5 limits chunks to between one number and 4 GB; contiguous storage is not
        // limited.
        double bytes = sizeof(double);
        for (const hsize_t n : chunk) bytes *= double(n);
        if (bytes > 0 && bytes < 4e9) {
            H5Pset_chunk(layout, int(chunk.size()), chunk.data());
            H5Pset_fletcher32(layout);
        }
        return {H5Dcreate2(file, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, layout,
                           H5P_DEFAULT),
                H5Dclose};
    }
    Handle group(const char* name) const {
        Handle made(
            H5Gcreate2(file, name, H5P_DEFAULT, timeless(H5P_GROUP_CREATE), H5P_DEFAULT),
            H5Gclose);
        check(made.good());
        return made;
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

/// Matrices in rows; Eigen stores columns.
std::vector<double> rows_of(std::span<const Mat3> frames) {
    std::vector<double> rows;
    rows.reserve(9 * frames.size());
    for (const Mat3& m : frames) {
        for (int r = 0; r < 3; ++r) rows.insert(rows.end(), {m(r, 0), m(r, 1), m(r, 2)});
    }
    return rows;
}

/// The three datasets of `frames` poses; for 0 frames, of one pose without the dimension
/// of frames.
struct PoseSets {
    Handle positions, rotations, curvatures;
    hsize_t guides, segments;
    bool numbered;

    PoseSets(const Writer& writer, hsize_t frames, hsize_t guides_, hsize_t segments_)
        : positions(made(writer, kPositions, frames, {guides_, 3})),
          rotations(made(writer, kFrames, frames, {guides_, 3, 3})),
          curvatures(made(writer, kCurvatures, frames, {guides_, segments_, 3})),
          guides(guides_),
          segments(segments_),
          numbered(frames > 0) {}

    static Handle made(const Writer& writer, const char* name, hsize_t frames,
                       std::vector<hsize_t> shape) {
        std::vector<hsize_t> chunk = shape;
        if (frames > 0) {
            shape.insert(shape.begin(), frames);
            chunk.insert(chunk.begin(), 1);
        }
        return writer.dataset(name + 1, shape, chunk);
    }
    void write(const Writer& writer, hsize_t frame, const Guides& pose) const {
        const auto block = [&](const Handle& into, std::vector<hsize_t> count,
                               const double* values) {
            std::vector<hsize_t> start(count.size(), 0);
            if (numbered) {
                start.insert(start.begin(), frame);
                count.insert(count.begin(), 1);
            }
            writer.write(into, start, count, values);
        };
        block(positions, {guides, 3}, pose.root_positions.data()->data());
        block(rotations, {guides, 3, 3}, rows_of(pose.root_frames).data());
        block(curvatures, {guides, segments, 3}, pose.curvatures.data()->data());
    }
};

/// The shape that all poses of a cache share.
struct Shape {
    std::size_t guides;
    int segments;
    std::vector<double> lengths;

    explicit Shape(const Guides& pose)
        : guides(pose.size()), segments(pose.segments), lengths(pose.segment_lengths) {
        require(guides > 0 && segments > 0,
                "guide cache: expected at least one guide and segment");
        require(lengths.size() == guides * std::size_t(segments),
                "guide cache: expected one length per segment");
    }
    void check(const Guides& pose) const {
        require(pose.size() == guides && pose.segments == segments &&
                    pose.root_frames.size() == guides &&
                    pose.curvatures.size() == guides * std::size_t(segments),
                "guide cache: the frames differ in guides or segments");
        require(pose.segment_lengths == lengths,
                "guide cache: the frames differ in segment lengths");
    }
};

void check_restart(const Restart& restart) {
    for (const auto& [name, values] : restart.arrays) {
        require(!name.empty() && name != "." &&
                    name.find_first_of(std::string("/\0", 2)) == std::string::npos,
                "guide cache: '" + name + "' is not a valid name of an array");
        require(std::ranges::all_of(values, [](double x) { return std::isfinite(x); }),
                "guide cache: the array '" + name + "' is not finite");
    }
}

void write_restart(const Writer& writer, const Restart& restart) {
    const Handle group = writer.group(kRestart);
    const Writer into{writer.path, group};
    into.attribute("job", restart.job);
    for (const auto& [name, values] : restart.arrays) {
        const hsize_t size = values.size();
        const Handle data = into.dataset(name.c_str(), {size}, {size});
        if (size > 0) into.write(data, {0}, {size}, values.data());
    }
}

/// The format of HDF5 1.10 has checksums in all structures, and so do chunks (see
/// Writer::dataset), so that damage is detected.
Handle created(const std::filesystem::path& path) {
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_LATEST);
    return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, timeless(H5P_FILE_CREATE), access),
            H5Fclose};
}

}  // namespace

struct GuideCacheWriter::State {
    std::filesystem::path path;
    PendingFile pending;
    Handle file;
    Writer writer;
    hsize_t frames, next = 0;
    std::optional<Shape> shape;
    std::optional<PoseSets> sets;

    State(const std::filesystem::path& path_, hsize_t frames_)
        : path(path_),
          pending(path),
          file(created(pending.temporary())),
          writer{path, file},
          frames(frames_) {}

    /// The first pose sets the shape of all.
    void begin(const Guides& pose) {
        if (shape) return;
        shape.emplace(pose);
        shape->check(pose);
        const hsize_t guides = pose.size(), segments = hsize_t(pose.segments);
        const Handle lengths =
            writer.dataset(kLengths + 1, {guides, segments}, {guides, segments});
        writer.write(lengths, {0, 0}, {guides, segments}, shape->lengths.data());
        sets.emplace(writer, frames, guides, segments);
    }
};

GuideCacheWriter::GuideCacheWriter(const std::filesystem::path& path,
                                   const GuideCacheHeader& header, int frames,
                                   const Guides* rest) {
    require(frames > 0, "guide cache: expected at least one frame");
    const Session session;
    auto state =
        std::make_unique<State>(path, hsize_t(frames));  // destroyed before the session
    const Writer& writer = state->writer;
    writer.check(state->file.good());
    writer.attribute("format", kFormat);
    writer.attribute("version", H5T_NATIVE_INT, &kVersion);
    writer.attribute("units", kUnits);
    writer.attribute("frames_per_second", H5T_NATIVE_DOUBLE, &header.frames_per_second);
    writer.attribute("first_frame", H5T_NATIVE_INT, &header.first_frame);
    writer.attribute("groom", header.groom);
    if (rest) {
        state->begin(*rest);
        const Handle group = writer.group(kRest);
        const Writer into{path, group};
        PoseSets(into, 0, rest->size(), hsize_t(rest->segments)).write(into, 0, *rest);
    }
    state_ = std::move(state);
}

GuideCacheWriter::~GuideCacheWriter() {
    const Session session;
    state_.reset();
}

void GuideCacheWriter::add(const Guides& frame) {
    const Session session;
    require(state_->next < state_->frames, "guide cache: more frames than declared");
    state_->begin(frame);
    state_->shape->check(frame);
    state_->sets->write(state_->writer, state_->next++, frame);
}

void GuideCacheWriter::finish(const Restart* restart) {
    require(state_->next == state_->frames, "guide cache: fewer frames than declared");
    if (restart) check_restart(*restart);
    const Session session;
    if (restart) write_restart(state_->writer, *restart);
    state_->sets.reset();
    // A full disk may be reported only here.
    state_->writer.check(state_->file.close());
    state_->pending.commit();
}

void write_guide_cache(const std::filesystem::path& path, const GuideCacheHeader& header,
                       std::span<const Guides> frames) {
    require(frames.size() <= 0x7fffffff, "guide cache: too many frames");
    GuideCacheWriter writer(path, header, int(frames.size()));
    for (const Guides& frame : frames) writer.add(frame);
    writer.finish();
}

}  // namespace lancret
