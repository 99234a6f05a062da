#pragma once
// When a groom moves.

#include "guides/files/guide_cache.h"
#include "procedural/motion/posed_binding.h"

namespace lancret {

/// Where a groom's guides and scalp are in time, as an artist counts frames.
struct GroomTimes {
    std::filesystem::path cache;  ///< empty: the groom is no cache and holds still
    GuideCacheInfo info;          ///< of the cache
    ScalpPoseAt pose_at;          ///< none: the scalp stays at rest

    bool moves() const { return !cache.empty(); }
    int first() const { return info.first_frame; }
    int last() const { return info.first_frame + (info.frames - 1); }
};

/// The cache of guides that a groom names, or nothing.
std::filesystem::path cache_of(const GroomSettings& groom);

/// Throws InputError where the groom's cache cannot be read.
GroomTimes groom_times(const GroomSettings& groom, ScalpPoseAt pose_at);

}  // namespace lancret
