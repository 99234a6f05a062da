#pragma once
// Thresholds of blend option1, shared by the scalar blend and its vector kernel.

namespace lancret::option1 {

/// Share of the guides' mean that is added to a quotient's numerator and denominator. It
/// has an effect only if the denominator has fallen to this share of its maximum.
template <class T>
inline constexpr T kSteady = T(1e-5);

/// A bend of this size, 1/cm, has no direction.
template <class T>
inline constexpr T kNothing = T(1e-12);

/// 1/cm, added to every guide's curvature when normals are averaged, so that straight
/// guides contribute the normal that they carry.
template <class T>
inline constexpr T kFaint = T(1e-6);

/// Share of the guides' mean curvature below which the blended torsion passes to the
/// guides' mean torsion.
template <class T>
inline constexpr T kFloor = T(1e-3);

}  // namespace lancret::option1
