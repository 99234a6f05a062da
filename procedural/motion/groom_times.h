#pragma once
// The frames of a groom.

#include <filesystem>

#include "guides/files/guide_cache.h"
#include "guides/motion/scalp_pose.h"
#include "procedural/groom/groom.h"

namespace lancret {

/// The frames of a groom's guides and the poses of its scalp.
struct GroomTimes {
    std::filesystem::path cache;  ///< empty: the groom has no cache and does not move
    GuideCacheInfo info;          ///< of the cache
    ScalpPoseAt pose_at;          ///< null: the scalp stays at rest

    bool moves() const { return !cache.empty(); }
    int first() const { return info.first_frame; }
    int last() const { return info.first_frame + (info.frames - 1); }
};

/// The guide cache that a groom names; empty if none.
std::filesystem::path cache_of(const GroomSettings& groom);

/// Throws InputError if the groom's cache cannot be read.
GroomTimes groom_times(const GroomSettings& groom, ScalpPoseAt pose_at);

}  // namespace lancret
