#pragma once

#include "guides/helix/helix.h"

namespace lancret {

/// The pose of a root at one time and its derivatives, in world space, which drive a
/// strand [Bergbom07, Eq. 4.3, 4.4]. The frame n_i of the pose obeys n_i' =
/// angular_velocity x n_i.
struct RootMotion {
    HelixState<double> pose;
    Vec3 velocity = Vec3::Zero();              ///< of the root's position, cm/s
    Vec3 angular_velocity = Vec3::Zero();      ///< rad/s
    Vec3 acceleration = Vec3::Zero();          ///< of the root's position, cm/s^2
    Vec3 angular_acceleration = Vec3::Zero();  ///< rad/s^2
};

}  // namespace lancret
