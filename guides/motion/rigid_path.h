#pragma once
// A rigid motion by key frames.

#include <array>
#include <vector>

#include "guides/base/rigid_pose.h"

namespace lancret {

/// A pose at a frame.
struct PoseKey {
    double frame = 0;
    Vec3 translation = Vec3::Zero();  ///< cm
    Vec3 rotation = Vec3::Zero();  ///< about the path's pivot: axis times angle, degrees
};

/// Keys and their slopes. Made by make_rigid_path and not modified afterwards.
struct RigidPath {
    std::vector<double> frames;  ///< [keys], strictly increasing
    /// [6][keys]: translation (cm), then rotation vector (rad)
    std::array<std::vector<double>, 6> values;
    std::array<std::vector<double>, 6> slopes;  ///< [6][keys], per frame
    Vec3 pivot = Vec3::Zero();                  ///< cm
    double frames_per_second = 24;
};

/// A rigid path at one time, x -> pose x, and its derivatives per second.
struct RigidMotion {
    RigidPose pose;
    Vec3 pivot = Vec3::Zero();                 ///< its current position, cm
    Vec3 velocity = Vec3::Zero();              ///< of the pivot, cm/s
    Vec3 angular_velocity = Vec3::Zero();      ///< rad/s
    Vec3 acceleration = Vec3::Zero();          ///< of the pivot, cm/s^2
    Vec3 angular_acceleration = Vec3::Zero();  ///< rad/s^2
};

/// A path through `keys`. Each component of translation and of rotation vector is a
/// monotone cubic in time: no overshoot, C1, at rest at and beyond the first and last
/// key. (A rotation by two turns makes both turns, never a short cut.) Throws
/// std::invalid_argument if there are no keys, a number is beyond 1e9, frames do not
/// increase by at least 1e-6, or frames_per_second is not above 0.
RigidPath make_rigid_path(std::vector<PoseKey> keys, const Vec3& pivot,
                          double frames_per_second);

/// The path at `frame` (finite). The rotation is exp(hat(theta)); with V the left
/// Jacobian of the exponential, angular velocity is V theta' and angular acceleration V
/// theta'' + V' theta', both in closed form. Accelerations jump at keys: the value at
/// a key is that just after it, at the last key that just before it.
RigidMotion rigid_motion(const RigidPath& path, double frame);

}  // namespace lancret
