#pragma once
// The vector types and the units of the whole project.
//
// Units, everywhere unless stated otherwise: centimetre, gram, second, radian. Curvatures
// are in 1/cm. Axes are right-handed. A frame is a matrix whose columns are n0 (the
// tangent), n1 and n2.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <numbers>

namespace lancret {

inline constexpr double kPi = std::numbers::pi;
inline constexpr float kPif = std::numbers::pi_v<float>;

template <class T>
using Vec3T = Eigen::Matrix<T, 3, 1>;
template <class T>
using Mat3T = Eigen::Matrix<T, 3, 3>;

using Vec2 = Eigen::Vector2d;
using Vec3 = Vec3T<double>;
using Mat3 = Mat3T<double>;
using Vec2f = Eigen::Vector2f;
using Vec3f = Vec3T<float>;
using Mat3f = Mat3T<float>;

/// Position and radius, aligned to 16 bytes as Embree requires.
struct alignas(16) Point4f {
    float x, y, z, w;

    Vec3f xyz() const { return {x, y, z}; }
};

}  // namespace lancret
