#include "procedural/motion/groom_times.h"

#include <utility>

namespace lancret {

std::filesystem::path cache_of(const GroomSettings& groom) {
    if (!groom.guides_file.empty()) return groom.guides_file;
    return groom.strands_file.extension() == ".h5" ? groom.strands_file
                                                   : std::filesystem::path();
}

GroomTimes groom_times(const GroomSettings& groom, ScalpPoseAt pose_at) {
    GroomTimes out;
    out.pose_at = std::move(pose_at);
    out.cache = cache_of(groom);
    if (out.moves()) out.info = guide_cache_info(out.cache);
    return out;
}

}  // namespace lancret
