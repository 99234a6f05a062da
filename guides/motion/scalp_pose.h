#pragma once
// The pose of the scalp at one time, and the poses of points on it.

#include <functional>
#include <span>
#include <variant>
#include <vector>

#include "guides/base/rigid_pose.h"
#include "guides/motion/scalp_motion.h"

namespace lancret {

/// The scalp at one time: a rigid pose of the rest mesh, or a deformed mesh with the same
/// triangles.
using ScalpPose = std::variant<RigidPose, TriangleMesh>;

/// The pose of a moving scalp at one time.
ScalpPose scalp_pose(const ScalpTime& scalp);

/// The scalp's pose at a frame number.
using ScalpPoseAt = std::function<ScalpPose(double frame)>;

/// The poses by which the scalp carries `count` places. For a rigid pose, that pose; for
/// a posed mesh, the frame of each place's triangle (first edge, across, normal) with the
/// place as its origin. Throws InputError if such a triangle has no area or there are no
/// places, std::invalid_argument if a place is not on the mesh.
std::vector<RigidPose> carriers(const ScalpPose& pose, std::span<const MeshPoint> places,
                                std::size_t count);

/// The visible head at that time: `rest` moved by a rigid pose, or the posed mesh itself.
TriangleMesh posed_mesh(const TriangleMesh& rest, const ScalpPose& pose);

}  // namespace lancret
