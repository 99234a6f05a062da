#include "sim/segment/second_derivative.h"

namespace lancret {

namespace {

/// Twice the polar form of K^2 e0 = k0 k - |k|^2 e0, which is quadratic in k.
Vec3 square_form(const Vec3& a, const Vec3& b) {
    return a.x() * b + b.x() * a - 2 * a.dot(b) * Vec3::UnitX();
}

}  // namespace

SegmentSecondDerivative::SegmentSecondDerivative(const Vec3& k, double u) : k_(k) {
    const double x = u * u * k.squaredNorm();
    StumpffTail<double> tail;
    const Stumpff<double> c = stumpff_functions(x, stumpff_halvings(x), tail);
    const double u2 = u * u, u4 = u2 * u2;
    p2_ = u2 * c.c2;
    p3_ = u2 * u * c.c3;
    // dc_m/dx = (m c_{m+2} - c_{m+1}) / 2, once and twice.
    d2_ = u4 * (2 * c.c4 - c.c3);
    d3_ = u4 * u * (3 * c.c5 - c.c4);
    dd2_ = u4 * u2 * (2 * (4 * tail.c6 - c.c5) - (3 * c.c5 - c.c4));
    dd3_ = u4 * u2 * u * (3 * (5 * tail.c7 - tail.c6) - (4 * tail.c6 - c.c5));
}

Vec3 SegmentSecondDerivative::position(const Vec3& a, const Vec3& b) const {
    const Vec3 e0 = Vec3::UnitX();
    const double ka = k_.dot(a), kb = k_.dot(b), ab = a.dot(b);
    return (dd2_ * ka * kb + d2_ * ab) * k_.cross(e0) +
           d2_ * (ka * b + kb * a).cross(e0) +
           (dd3_ * ka * kb + d3_ * ab) * 0.5 * square_form(k_, k_) +
           d3_ * (ka * square_form(k_, b) + kb * square_form(k_, a)) +
           p3_ * square_form(a, b);
}

Vec3 SegmentSecondDerivative::angular(const Vec3& a, const Vec3& b) const {
    const double ka = k_.dot(a);
    const Vec3 kb = k_.cross(b);
    return d2_ * ka * kb + p2_ * a.cross(b) + d3_ * ka * k_.cross(kb) +
           p3_ * (a.cross(kb) + k_.cross(a.cross(b)));
}

}  // namespace lancret
