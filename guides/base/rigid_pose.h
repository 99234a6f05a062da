#pragma once

#include "guides/base/types.h"

namespace lancret {

/// A rotation, then a translation: x goes to rotation x + translation.
struct RigidPose {
    Mat3 rotation = Mat3::Identity();  ///< orthonormal, right-handed
    Vec3 translation = Vec3::Zero();   ///< cm
};

/// The image of x.
inline Vec3 operator*(const RigidPose& pose, const Vec3& x) {
    return pose.rotation * x + pose.translation;
}

/// The point whose image is x.
inline Vec3 inverse_image(const RigidPose& pose, const Vec3& x) {
    return pose.rotation.transpose() * (x - pose.translation);
}

}  // namespace lancret
