#include "render_test/material/longitudinal.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render_test/sampling/sampling.h"

namespace lancret {
namespace {

using Eigen::Array4f;
static_assert(kHairLobes == 4);

template <std::size_t N>
Array4f polynomial(const Array4f& x, const std::array<float, N>& coefficients) {
    Array4f sum = Array4f::Constant(coefficients[0]);
    for (std::size_t i = 1; i < N; ++i) sum = sum * x + coefficients[i];
    return sum;
}

/// The Bessel function I0(x) exp(-x - y) for x, y >= 0 [Abramowitz and Stegun,
/// Eq. 9.8.1-9.8.2], to a relative error of 2e-7 besides that of the exponential.
Array4f bessel_i0_scaled(const Array4f& x, const Array4f& y) {
    constexpr float kJoint = 3.75f;
    const auto small = x < kJoint;
    const Array4f low = x.min(kJoint) / kJoint, high = x.max(kJoint);
    const Array4f series = polynomial<7>(
        low.square(),
        {0.0045813f, 0.0360768f, 0.2659732f, 1.2067492f, 3.0899424f, 3.5156229f, 1.0f});
    const Array4f tail =
        polynomial<9>(kJoint / high,
                      {0.00392377f, -0.01647633f, 0.02635537f, -0.02057706f, 0.00916281f,
                       -0.00157565f, 0.00225319f, 0.01328592f, 0.39894228f}) /
        high.sqrt();
    return small.select(series, tail) * (-(y + small.select(x, 0.0f))).exp();
}

}  // namespace

TurnedInclination turned_inclination(const HairModel& model, float sine_o,
                                     float cosine_o) {
    return {sine_o * model.cosine + cosine_o * model.sine,
            (cosine_o * model.cosine - sine_o * model.sine).abs()};
}

/// M [d'Eon et al. 2011, Eq. 7; Chiang et al. 2016, Eq. 6] = exp(-b) I0(a) / (2 v
/// sinh(1/v)) with a = ci co / v and b = si so / v. The exponentials are combined into
/// exp((cos(ti + to) - 1) / v), which is at most one, so small v needs no branch.
Array4f longitudinal(const HairModel& model, const TurnedInclination& wo, float sine_i,
                     float cosine_i) {
    const Array4f& v = model.variance;
    const Array4f versine =
        0.5f * ((sine_i + wo.sine).square() + (cosine_i - wo.cosine).square());
    return bessel_i0_scaled(cosine_i * wo.cosine / v, versine / v) / (v * model.spread);
}

float sampled_sine(const HairModel& model, const TurnedInclination& wo, int lobe,
                   const Vec2f& random) {
    // M is sampled about the mirrored inclination [d'Eon et al. 2013, "Importance
    // Sampling for Physically-Based Hair Fiber Models"], by one minus the cosine, which
    // keeps its digits.
    const float versine = std::min(
        2.0f, -model.variance[lobe] * std::log1p(-model.spread[lobe] * random.x()));
    const float across = std::sqrt(versine * (2 - versine));
    return std::clamp(-(1 - versine) * wo.sine[lobe] +
                          across * std::cos(2 * kPif * random.y()) * wo.cosine[lobe],
                      -1.0f, 1.0f);
}

float length_across(const Vec3f& w) { return std::sqrt(square(w.y()) + square(w.z())); }

}  // namespace lancret
