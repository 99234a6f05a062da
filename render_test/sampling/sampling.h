#pragma once
// Random directions in closed form, and the weight that combines two sampling techniques.

#include <algorithm>
#include <cmath>

#include "guides/base/types.h"

namespace lancret {

inline float luminance(const Vec3f& colour) {
    return colour.dot(Vec3f(0.2126f, 0.7152f, 0.0722f));
}

/// Uniform on the unit sphere; density 1 / (4 pi).
inline Vec3f uniform_sphere(const Vec2f& random) {
    const float z = 1 - 2 * random.x(), phi = 2 * kPif * random.y();
    const float r = std::sqrt(std::max(0.0f, 1 - z * z));
    return {r * std::cos(phi), r * std::sin(phi), z};
}

/// Density cos / pi on the hemisphere about +z.
inline Vec3f cosine_hemisphere(const Vec2f& random) {
    const float r = std::sqrt(random.x()), phi = 2 * kPif * random.y();
    return {r * std::cos(phi), r * std::sin(phi),
            std::sqrt(std::max(0.0f, 1 - random.x()))};
}

/// An orthonormal matrix whose third column is the unit vector `z`.
inline Mat3f frame_about(const Vec3f& z) {
    Mat3f frame;
    frame.col(2) = z;
    frame.col(0) = z.unitOrthogonal();
    frame.col(1) = z.cross(frame.col(0));
    return frame;
}

/// Power heuristic of exponent 2 for the technique of density `mine` [Veach 1997,
/// Sec. 9.2.4]. Both finite, `mine` > 0.
inline float mis_weight(float mine, float other) {
    const float ratio = other / mine;
    return 1 / (1 + ratio * ratio);
}

}  // namespace lancret
