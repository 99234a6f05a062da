#pragma once
// Reading guide caches: guides of consecutive frames in an HDF5 file, which h5py and
// h5dump read as well. docs/formats.md shows how to read one in Python.
//
//   /root_positions   [frames, guides, 3]            cm
//   /root_frames      [frames, guides, 3, 3]         row r, column c, as a matrix is
//                                                    written: the columns are n0, n1, n2
//   /segment_lengths  [guides, segments]             cm, the same in every frame
//   /curvatures       [frames, guides, segments, 3]  (k0, k1, k2), 1/cm
//   /rest                                            optional: the rest pose
//     root_positions, root_frames, curvatures        as above, without [frames]
//   /restart                                         optional: to continue the run after
//     any names  [any]                               the last frame; attribute `job`
// All are 64-bit floats (32-bit ones are read too), in chunks of one frame, with
// checksums throughout (HDF5 1.10 and later), so that damage is found, and without time
// stamps, so that equal contents give equal bytes. Attributes of the root group:
// `format` ("lancret guide cache"), `version` (1), `units` ("cm g s rad"),
// `frames_per_second`, `first_frame` and `groom`.

#include <filesystem>
#include <string>

#include "guides/helix/guides.h"

namespace lancret {

/// The attributes of a cache.
struct GuideCacheHeader {
    double frames_per_second = 24;
    int first_frame = 1;  ///< the frame number of the file's frame 0
    std::string groom;    ///< path of the groom that the guides belong to, or empty
};

/// The attributes and the contents of a cache.
struct GuideCacheInfo : GuideCacheHeader {
    int frames = 0;
    std::size_t guides = 0;
    int segments = 0;          ///< per guide
    bool has_rest = false;     ///< has the rest pose
    bool has_restart = false;  ///< has what continuing the run needs
};

/// The attributes and shapes of a cache. Throws InputError with the file and the dataset
/// or attribute if it is not a cache of this version.
GuideCacheInfo guide_cache_info(const std::filesystem::path& path);

/// The guides of a frame, 0 <= frame < frames, bit for bit as written; reads nothing else
/// of the file. Throws InputError as guide_cache_info does, and if a number is not
/// finite, a root frame is not a rotation to 1e-6, or a segment's length is not above 0;
/// std::invalid_argument if there is no such frame.
Guides read_guide_cache(const std::filesystem::path& path, int frame);

/// The guides at rest; without a rest pose, those of the first frame. Throws as
/// read_guide_cache does.
Guides read_rest_guides(const std::filesystem::path& path);

/// Whether reading accepts `m` as a rotation: orthonormal to 1e-6 and no reflection.
bool is_cache_rotation(const Mat3& m);

}  // namespace lancret
