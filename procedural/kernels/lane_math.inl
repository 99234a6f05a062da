// Included once for each instruction set: no #pragma once.
// Vectors and rotations, a strand in each lane, and the closed forms of a helix as
// polynomials.

#if defined(LANCRET_LANE_MATH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LANCRET_LANE_MATH_INL
#undef LANCRET_LANE_MATH_INL
#else
#define LANCRET_LANE_MATH_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace lancret::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;

HWY_INLINE V set(float x) { return hn::Set(D(), x); }

struct Lanes3 {
    V x, y, z;
};

HWY_INLINE Lanes3 operator+(const Lanes3& a, const Lanes3& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Lanes3 operator-(const Lanes3& a, const Lanes3& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Lanes3 times(V s, const Lanes3& a) {
    return {hn::Mul(s, a.x), hn::Mul(s, a.y), hn::Mul(s, a.z)};
}
/// s a + b
HWY_INLINE Lanes3 times_plus(V s, const Lanes3& a, const Lanes3& b) {
    return {hn::MulAdd(s, a.x, b.x), hn::MulAdd(s, a.y, b.y), hn::MulAdd(s, a.z, b.z)};
}
HWY_INLINE V dot(const Lanes3& a, const Lanes3& b) {
    return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
}
/// a cross b + c
HWY_INLINE Lanes3 cross_plus(const Lanes3& a, const Lanes3& b, const Lanes3& c) {
    return {hn::NegMulAdd(a.z, b.y, hn::MulAdd(a.y, b.z, c.x)),
            hn::NegMulAdd(a.x, b.z, hn::MulAdd(a.z, b.x, c.y)),
            hn::NegMulAdd(a.y, b.x, hn::MulAdd(a.x, b.y, c.z))};
}
HWY_INLINE Lanes3 cross(const Lanes3& a, const Lanes3& b) {
    return {hn::NegMulAdd(a.z, b.y, hn::Mul(a.y, b.z)),
            hn::NegMulAdd(a.x, b.z, hn::Mul(a.z, b.x)),
            hn::NegMulAdd(a.y, b.x, hn::Mul(a.x, b.y))};
}

/// A quaternion w + v.
struct Lanes4 {
    V w;
    Lanes3 v;
};

HWY_INLINE V dot(const Lanes4& a, const Lanes4& b) {
    return hn::MulAdd(a.w, b.w, dot(a.v, b.v));
}
HWY_INLINE Lanes4 times(V s, const Lanes4& q) { return {hn::Mul(s, q.w), times(s, q.v)}; }

/// The rotation b and then a.
HWY_INLINE Lanes4 product(const Lanes4& a, const Lanes4& b) {
    return {hn::Sub(hn::Mul(a.w, b.w), dot(a.v, b.v)),
            cross_plus(a.v, b.v, times_plus(a.w, b.v, times(b.w, a.v)))};
}

HWY_INLINE Lanes4 conjugate(const Lanes4& q) {
    return {q.w, {hn::Neg(q.v.x), hn::Neg(q.v.y), hn::Neg(q.v.z)}};
}

/// p rotated by q, |q| = 1.
HWY_INLINE Lanes3 rotated(const Lanes4& q, const Lanes3& p) {
    const Lanes3 twice = times(set(2), cross(q.v, p));
    return cross_plus(q.v, twice, times_plus(q.w, twice, p));
}

/// |q|^2 times the image of the first axis under the rotation along q, of any length.
HWY_INLINE Lanes3 first_axis(const Lanes4& q) {
    const V ww_xx = hn::MulAdd(q.v.x, q.v.x, hn::Mul(q.w, q.w));
    return {hn::NegMulAdd(q.v.z, q.v.z, hn::NegMulAdd(q.v.y, q.v.y, ww_xx)),
            hn::Mul(set(2), hn::MulAdd(q.v.x, q.v.y, hn::Mul(q.w, q.v.z))),
            hn::Mul(set(2), hn::NegMulAdd(q.w, q.v.y, hn::Mul(q.v.x, q.v.z)))};
}

/// q at unit length; q is not zero.
HWY_INLINE Lanes4 normalized(const Lanes4& q) {
    return times(hn::Div(set(1), hn::Sqrt(dot(q, q))), q);
}

/// q at unit length, by one Newton step; q has unit length up to round-off.
HWY_INLINE Lanes4 renormalized(const Lanes4& q) {
    return times(hn::NegMulAdd(set(0.5f), dot(q, q), set(1.5f)), q);
}

/// Horner's rule; c[0] is the constant.
template <std::size_t kCount>
HWY_INLINE V polynomial(V x, const float (&c)[kCount]) {
    V sum = set(c[kCount - 1]);
    for (std::size_t k = kCount - 1; k-- > 0;) sum = hn::MulAdd(x, sum, set(c[k]));
    return sum;
}

// Chebyshev interpolation on the given range, with the maximum error: absolute for the
// first three, relative for the others. Half an ulp of 1 is 6e-8.

/// cos sqrt(y), y in [0, pi^2]: 2e-10.
constexpr float kCosine[] = {9.999999999e-01f,  -4.999999985e-01f, 4.166666348e-02f,
                             -1.388886297e-03f, 2.480055131e-05f,  -2.753476714e-07f,
                             2.060332760e-09f,  -9.721726448e-12f};
/// sin sqrt(y) / sqrt(y), y in [0, pi^2]: 8e-10.
constexpr float kSinc[] = {9.999999993e-01f,  -1.666666592e-01f, 8.333321236e-03f,
                           -1.984053154e-04f, 2.753580020e-06f,  -2.472836363e-08f,
                           1.361158568e-10f};
/// (t - sin t) / t^3 as a function of x = t^2, in [0, 4 pi^2]: 1e-9.
constexpr float kThird[] = {1.666666657e-01f,  -8.333330039e-03f, 1.984109388e-04f,
                            -2.755372585e-06f, 2.501588377e-08f,  -1.585905540e-10f,
                            7.025528928e-13f,  -1.765459113e-15f};
// As functions of z = 1 - cos h in [0, 1], where h is half of an angle up to pi.
/// (h - sin h) / (h sin^2 h): 6e-8.
constexpr float kAlong[] = {1.666666566e-01f,  9.444644475e-02f, 4.980255211e-02f,
                            2.655951121e-02f,  8.056364657e-03f, 2.467966518e-02f,
                            -3.430541858e-02f, 4.851122024e-02f, -3.151189231e-02f,
                            1.047510363e-02f};
/// sin h / (2 h (1 + cos h)): 6e-9.
constexpr float kMiddle[] = {2.499999989e-01f,  4.166687866e-02f, 1.527086723e-02f,
                             6.402566949e-03f,  2.210666339e-03f, 3.152507983e-03f,
                             -3.460321422e-03f, 5.283701365e-03f, -3.374442464e-03f,
                             1.157460538e-03f};

/// The step of a helix, expressed in the frame at its start, as helix_step computes it;
/// for turns up to 2 pi.
struct LanesStep {
    Lanes4 turn;
    Lanes3 displacement;  ///< over ds
};

HWY_INLINE LanesStep lanes_step(const Lanes3& w) {
    const V x = dot(w, w), y = hn::Mul(set(0.25f), x);
    const V cosine = polynomial(y, kCosine), sinc = polynomial(y, kSinc);
    const V half = hn::Mul(set(0.5f), sinc);
    const V c2 = hn::Mul(half, sinc), c3x = hn::Mul(polynomial(x, kThird), w.x);
    return {{cosine, times(half, w)},
            {hn::MulAdd(cosine, sinc, hn::Mul(c3x, w.x)),
             hn::MulAdd(c2, w.z, hn::Mul(c3x, w.y)),
             hn::NegMulAdd(c2, w.y, hn::Mul(c3x, w.z))}};
}

/// The helix between two frames.
struct LanesBetween {
    Lanes4 turn;   ///< rotation in space from the first frame to the second
    Lanes3 chord;  ///< over the arc length
};

/// The quaternions of the frames have the dot product `cosine` >= 0.
///
/// In the frame in the middle, the chord of a helix that turns by 2 h about the axis a is
/// (sin h / h) e0 + (1 - sin h / h) (e0 . a) a.
HWY_INLINE LanesBetween lanes_between(const Lanes4& from, const Lanes4& to, V cosine) {
    const V z = hn::Sub(set(1), cosine);
    const Lanes4 turn = product(to, conjugate(from));
    const Lanes4 middle = {hn::Add(from.w, to.w), from.v + to.v};
    // The component of the turn's axis along the tangent, the same at both ends.
    const V along = hn::NegMulAdd(
        from.v.x, to.w,
        hn::MulAdd(from.v.z, to.v.y,
                   hn::NegMulAdd(from.v.y, to.v.z, hn::Mul(from.w, to.v.x))));
    const V share = hn::Mul(polynomial(z, kAlong), along);
    return {{cosine, turn.v},
            times_plus(polynomial(z, kMiddle), first_axis(middle), times(share, turn.v))};
}

}  // namespace lancret::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
