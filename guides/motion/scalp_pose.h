#pragma once
// The scalp at one time, and what it carries.

#include <functional>
#include <span>
#include <variant>
#include <vector>

#include "guides/base/rigid_pose.h"
#include "guides/motion/scalp_motion.h"

namespace lancret {

/// The scalp at some time: moved as a whole, or a mesh of its own with the triangles of
/// the rest pose.
using ScalpPose = std::variant<RigidPose, TriangleMesh>;

/// The pose of a moving scalp at one time.
ScalpPose scalp_pose(const ScalpTime& scalp);

/// The scalp's pose at a frame, as an artist counts frames.
using ScalpPoseAt = std::function<ScalpPose(double frame)>;

/// How the scalp carries what stands on it: of a rigid pose, that pose, `count` times; of
/// a posed mesh, for each of `places` ([count]) the frame of its triangle (first edge,
/// across, normal) with the place as its origin. Throws InputError where such a triangle
/// has no area or there are no places, std::invalid_argument where one is off the mesh.
std::vector<RigidPose> carriers(const ScalpPose& pose, std::span<const MeshPoint> places,
                                std::size_t count);

/// What is seen of the head at that time: `rest` moved along by a rigid pose; a posed
/// mesh takes its place.
TriangleMesh posed_mesh(const TriangleMesh& rest, const ScalpPose& pose);

}  // namespace lancret
