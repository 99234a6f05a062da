#pragma once
// One exact step along a helix. Everything in Lancret that moves along a strand uses it.
//
// The state of a strand at arc length s is a frame R = [n0 n1 n2] and a position r with
//     R' = R hat(u),   r' = R e0,
// where u = (k0, k1, k2) is the Darboux vector in that frame: twist, then two bending
// curvatures, 1/cm. Three framings share it: Cosserat u = (k0, k1, k2) [Bergbom07,
// Sec. 4.1], Frenet-Serret u = (tau, 0, kappa) [TW99, Sec. 2] and Bishop u = (0, k1, k2).
// For constant u the solution is closed and does not divide by a curvature; it replaces
// [TW99, Eq. 26-37, corrected] and [Bergbom07, Eq. 4.13-4.22, corrected].

#include <array>
#include <cmath>

#include "guides/base/types.h"

namespace lancret {

/// hat(u) x = u cross x.
template <class T>
Mat3T<T> hat(const Vec3T<T>& u) {
    Mat3T<T> m;
    m << 0, -u.z(), u.y(), u.z(), 0, -u.x(), -u.y(), u.x(), 0;
    return m;
}

/// c1 = sin t / t, c2 = (1 - cos t) / t^2, c3 = (t - sin t) / t^3, functions of x = t^2
/// that are smooth at zero.
template <class T>
struct StepKernel {
    T c1, c2, c3;
};

/// 1 / (k (k + 1)): the ratio of consecutive terms of the series.
template <class T>
inline constexpr auto kOverPair = [] {
    std::array<T, 21> out{};
    for (int k = 1; k < 21; ++k) out[k] = T(1) / T(k * (k + 1));
    return out;
}();

/// The kernel at x = t^2 >= 0: Taylor series below 1, closed forms above.
template <class T>
StepKernel<T> step_kernel(T x) {
    if (x < T(1)) {
        // c2 and c3 by Horner's rule, to round-off at x = 1; then c1 = 1 - x c3.
        constexpr int kTerms = sizeof(T) == 4 ? 5 : 9;
        T c2 = 1, c3 = 1;
        for (int n = kTerms; n > 0; --n) {
            c2 = 1 - x * c2 * kOverPair<T>[2 * n + 1];
            c3 = 1 - x * c3 * kOverPair<T>[2 * n + 2];
        }
        c2 /= 2;
        c3 /= 6;
        return {1 - x * c3, c2, c3};
    }
    const T t = std::sqrt(x), half_sine = std::sin(t / 2), sine = std::sin(t);
    return {sine / t, 2 * half_sine * half_sine / x, (t - sine) / (t * x)};
}

/// dc2/dx and dc3/dx of the step kernel, x = t^2.
struct KernelSlope {
    double c2, c3;
};

/// The kernel's slope at x = t^2 >= 0, smooth at zero.
KernelSlope kernel_slope(double x);

/// The effect of one step, expressed in the frame at its start.
template <class T>
struct HelixStep {
    Mat3T<T> rotation;      ///< E with R(s + ds) = R(s) E
    Vec3T<T> displacement;  ///< d with r(s + ds) = r(s) + R(s) d, cm
};

/// The step of arc length `ds` (cm, either sign) at constant Darboux vector `u` (1/cm).
template <class T>
HelixStep<T> helix_step(const Vec3T<T>& u, T ds) {
    const Vec3T<T> w = u * ds;
    const T x = w.squaredNorm();
    const auto [c1, c2, c3] = step_kernel(x);
    HelixStep<T> step;
    // K = hat(w), K^2 = w w^T - x I.
    step.rotation = c1 * hat<T>(w) + c2 * w * w.transpose();
    step.rotation.diagonal().array() += 1 - c2 * x;
    step.displacement =
        ds * Vec3T<T>(1 - c3 * x + c3 * w.x() * w.x(), c2 * w.z() + c3 * w.x() * w.y(),
                      -c2 * w.y() + c3 * w.x() * w.z());
    return step;
}

/// The frame and the position at a place on a strand.
template <class T>
struct HelixState {
    Mat3T<T> frame = Mat3T<T>::Identity();  ///< [n0 n1 n2], orthonormal
    Vec3T<T> position = Vec3T<T>::Zero();   ///< cm
};

/// Moves `state` by arc length `ds` along the helix of Darboux vector `u`.
template <class T>
void advance(HelixState<T>& state, const Vec3T<T>& u, T ds) {
    const HelixStep<T> step = helix_step<T>(u, ds);
    state.position += state.frame * step.displacement;
    state.frame = (state.frame * step.rotation).eval();
}

/// Removes round-off from a nearly orthonormal frame by one Newton step towards the
/// nearest rotation, R (3 - R^T R) / 2. An error e of R^T R = I becomes one of order e^2.
template <class T>
void orthonormalize(Mat3T<T>& frame) {
    const Mat3T<T> gram = frame.transpose() * frame;
    frame = (frame * (T(1.5) * Mat3T<T>::Identity() - T(0.5) * gram)).eval();
}

/// The rotation vector w with exp(hat(w)) = rotation and |w| <= pi; inverse of
/// helix_step(w, 1).rotation there.
template <class T>
Vec3T<T> rotation_log(const Mat3T<T>& rotation) {
    Eigen::Quaternion<T> q(rotation);
    if (q.w() < 0) q.coeffs() = -q.coeffs();
    const T sine = q.vec().norm();
    if (sine == 0) return Vec3T<T>::Zero();
    return q.vec() * (2 * std::atan2(sine, q.w()) / sine);
}

/// The displacement, cm, in `from`, of the helix of length `ds` (cm) that begins with the
/// frame `from`, ends with `to`, and turns by less than half a turn.
template <class T>
Vec3T<T> displacement_between(const Mat3T<T>& from, const Mat3T<T>& to, T ds) {
    const Mat3T<T> turn = from.transpose() * to;
    return helix_step<T>(rotation_log<T>(turn) / ds, ds).displacement;
}

/// The derivative of helix_step with respect to the Darboux vector (k0, k1, k2),
/// expressed in the frame at the start of the step.
struct HelixStepDerivative {
    /// V: a change dk turns the end frame by the rotation vector V dk, cm. Column i is
    /// d(phi)/d(k_i).
    Mat3 angular;
    /// Column i is d(displacement)/d(k_i), cm^2.
    Mat3 position;
};

/// The derivative of the step of arc length `ds` at Darboux vector `u`; smooth through
/// |u| = 0.
HelixStepDerivative helix_step_derivative(const Vec3& u, double ds);

/// The smallest rotation that takes the unit vector `from` to the unit vector `to`; half
/// a turn about an axis across `from` if they are opposite.
template <class T>
Mat3T<T> smallest_rotation(const Vec3T<T>& from, const Vec3T<T>& to) {
    const Vec3T<T> axis = from.cross(to);
    const T cosine = from.dot(to);
    if (cosine < T(-1) + T(1e-6)) {
        const Vec3T<T> across = from.unitOrthogonal();
        return 2 * across * across.transpose() - Mat3T<T>::Identity();
    }
    Mat3T<T> r = hat<T>(axis) + axis * axis.transpose() / (1 + cosine);
    r.diagonal().array() += cosine;
    return r;
}

}  // namespace lancret
