#include "procedural/groom/head_pose.h"

#include <memory>

#include "procedural/groom/placed_guides.h"

namespace lancret {

ScalpPoseAt head_pose(const MotionSettings& motion, const GroomSettings& groom) {
    if (motion.still()) return {};
    std::optional<TriangleMesh> rest;
    if (motion.deforms()) rest = read_scalp_mesh(groom);
    constexpr double kFramesPerSecond = 24;  // any: poses do not depend on speeds
    const auto path = std::make_shared<const ScalpMotion>(
        scalp_motion(motion, rest ? &*rest : nullptr, kFramesPerSecond));
    return [path](double frame) { return scalp_pose(scalp_at(*path, frame)); };
}

}  // namespace lancret
