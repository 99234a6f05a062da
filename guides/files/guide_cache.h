#pragma once
// The guide cache: guides for a run of frames in an HDF5 file, for h5py and h5dump as
// well as for Lancret. docs/formats.md tells how to read one in Python.
//
//   /root_positions   [frames, guides, 3]            cm
//   /root_frames      [frames, guides, 3, 3]         row r, column c, as the matrix is
//                                                    written: the columns are n0, n1, n2
//   /segment_lengths  [guides, segments]             cm, the same in every frame
//   /curvatures       [frames, guides, segments, 3]  (k0, k1, k2), 1/cm
//   /rest                                            where the rest pose is known:
//     root_positions, root_frames, curvatures        as above, without [frames]
//   /restart                                         where a run can go on from the last
//     any names  [any]                               frame; attribute `job`
// All are 64-bit floats (32-bit ones are read too), in chunks of one frame, with
// checksums throughout (HDF5 1.10 and later), so that damage is found, and without time
// stamps, so that the same contents are the same bytes. Attributes of the root group:
// `format` ("lancret guide cache"), `version` (1), `units` ("cm g s rad"),
// `frames_per_second`, `first_frame` and `groom`.

#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "guides/helix/guides.h"

namespace lancret {

/// What a cache says of itself beside the guides.
struct GuideCacheHeader {
    double frames_per_second = 24;
    int first_frame = 1;  ///< the number of frame 0 of the file, as an artist counts
    std::string groom;    ///< the path of the groom that these guides belong to, or empty
};

/// What is in a cache.
struct GuideCacheInfo : GuideCacheHeader {
    int frames = 0;
    std::size_t guides = 0;
    int segments = 0;          ///< of each guide
    bool has_rest = false;     ///< the rest pose is there
    bool has_restart = false;  ///< what a run needs to go on is there
};

/// Named numbers, all finite. A name has at least one character, none of them a '/', and
/// is not ".".
using RestartArrays = std::map<std::string, std::vector<double>>;

/// What a run needs beside the guides of its last frame to go on.
struct Restart {
    std::string job;  ///< identifies the run: groom, guides and settings
    RestartArrays arrays;
};

/// Writes a cache of these frames. Throws InputError where the file cannot be written,
/// and std::invalid_argument where there is no frame or no guide, or where the frames
/// differ in the number of guides or segments or in segment lengths.
void write_guide_cache(const std::filesystem::path& path, const GuideCacheHeader& header,
                       std::span<const Guides> frames);

/// Writes a cache frame by frame, so that one of them is in memory at a time. The file is
/// in its place when `finish` is done; until then an older one stays. The same contents
/// are the same bytes.
class GuideCacheWriter {
  public:
    /// A cache of `frames` frames, and the rest pose where there is one. Throws
    /// InputError where the file cannot be written, std::invalid_argument without frames.
    GuideCacheWriter(const std::filesystem::path& path, const GuideCacheHeader& header,
                     int frames, const Guides* rest = nullptr);
    ~GuideCacheWriter();
    GuideCacheWriter(const GuideCacheWriter&) = delete;
    GuideCacheWriter& operator=(const GuideCacheWriter&) = delete;

    /// The next frame. Throws as write_guide_cache does.
    void add(const Guides& frame);
    /// Once all frames are there. Throws InputError where the disk is full, and
    /// std::invalid_argument where frames are missing or `restart` breaks its rules.
    void finish(const Restart* restart = nullptr);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// What a cache holds, by its attributes and shapes. Throws InputError, which names the
/// file and the dataset or attribute, where it is not a cache of this version.
GuideCacheInfo guide_cache_info(const std::filesystem::path& path);

/// The guides of a frame, 0 <= frame < frames; nothing else of the file is read. The same
/// bits as were written. Throws InputError as guide_cache_info does and where a number is
/// not finite, a root frame is not a rotation to 1e-6, or a segment's length is not above
/// 0; std::invalid_argument where there is no such frame.
Guides read_guide_cache(const std::filesystem::path& path, int frame);

/// The guides at rest; where the cache does not say, those of its first frame. Throws as
/// read_guide_cache does.
Guides read_rest_guides(const std::filesystem::path& path);

/// What a run needs to go on after the last frame. Throws InputError where it is not
/// there or is damaged.
Restart read_restart(const std::filesystem::path& path);

/// Whether reading takes `m` for a rotation: orthonormal to 1e-6 and no reflection.
bool is_cache_rotation(const Mat3& m);

}  // namespace lancret
