#include "render_test/hair_bsdf.h"

#include <cmath>
#include <stdexcept>

#include "render_test/sampling.h"

namespace lancret {
namespace {

float square(float x) { return x * x; }

/// The odd power of x, by squaring.
float power(float x, int n) {
    float result = 1;
    for (; n; n >>= 1, x *= x)
        if (n & 1) result *= x;
    return result;
}

/// The Bessel function I0(x) exp(-x) for x >= 0 [Abramowitz and Stegun, Eq. 9.8.1-9.8.2],
/// to 2e-7 of its value.
float bessel_i0_scaled(float x) {
    if (x < 3.75f) {
        const float t = square(x / 3.75f);
        const float i0 =
            1 + t * (3.5156229f +
                     t * (3.0899424f +
                          t * (1.2067492f +
                               t * (0.2659732f + t * (0.0360768f + t * 0.0045813f)))));
        return i0 * std::exp(-x);
    }
    const float t = 3.75f / x;
    float p = 0.00392377f;
    for (const float c : {-0.01647633f, 0.02635537f, -0.02057706f, 0.00916281f,
                          -0.00157565f, 0.00225319f, 0.01328592f, 0.39894228f})
        p = p * t + c;
    return p / std::sqrt(x);
}

/// M [d'Eon et al. 2011, Eq. 7; Chiang et al. 2016, Eq. 6] = exp(-b) I0(a) / (2 v
/// sinh(1/v)) with a = ci co / v and b = si so / v. The exponentials are joined into
/// exp((cos(ti + to) - 1) / v), which is at most one for any v: no branch for small v.
float longitudinal(float sine_i, float cosine_i, float sine_o, float cosine_o,
                   const HairModel::Lobe& lobe) {
    const float v = lobe.variance;
    const float versine = 0.5f * (square(sine_i + sine_o) + square(cosine_i - cosine_o));
    return std::exp(-versine / v) * bessel_i0_scaled(cosine_i * cosine_o / v) /
           (v * lobe.spread);
}

/// N: the logistic of scale s, trimmed to [-pi, pi] [Chiang et al. 2016, Eq. 8].
float azimuthal(float x, const HairModel& model) {
    const float e = std::exp(-std::abs(x) / model.s);
    return e / (model.s * square(1 + e) * (1 - 2 * model.s_tail));
}

float sampled_azimuth(float random, const HairModel& model) {
    const float p = model.s_tail + random * (1 - 2 * model.s_tail);
    return std::clamp(model.s * std::log(p / (1 - p)), -kPi, kPi);
}

/// The angle less the whole turns nearest to it.
float wrapped(float angle) {
    return angle - 2 * kPi * std::floor(angle / (2 * kPi) + 0.5f);
}

}  // namespace

float fresnel_dielectric(float cosine, float eta) {
    const float sine_t2 = (1 - square(cosine)) / square(eta);
    const float cosine_t = std::sqrt(1 - sine_t2);
    const float parallel = (eta * cosine - cosine_t) / (eta * cosine + cosine_t);
    const float across = (cosine - eta * cosine_t) / (cosine + eta * cosine_t);
    return 0.5f * (square(parallel) + square(across));
}

HairModel::HairModel(const HairMaterial& material)
    : sigma_a(sigma_a_of(material)), eta(material.eta) {
    const float m = material.beta_m, n = material.beta_n;
    if (!(m >= 0.01f && m <= 1) || !(n >= 0.01f && n <= 1))
        throw std::invalid_argument("hair roughness must be within 0.01 and 1");
    if (!(eta >= 1.01f && eta <= 5))
        throw std::invalid_argument("hair index of refraction must be within 1.01 and 5");
    if (!(std::abs(material.tilt) <= 0.5f))
        throw std::invalid_argument("hair tilt must be within -0.5 and 0.5 radian");
    // [Chiang et al. 2016, Eq. 7]: TT is half as wide as R, TRT and the rest twice.
    const float v = square(0.726f * m + 0.812f * m * m + 3.7f * power(m, 20));
    const std::array<float, kHairLobes> variances{v, v / 4, 4 * v, 4 * v};
    // Scales rise towards the tip, so their normals lean to the root. wo's inclination is
    // turned so that R shows at twice the tilt nearer the root, and TT and TRT nearer the
    // tip [Marschner et al. 2003, Sec. 4; angles as Chiang et al. 2016].
    const std::array<float, kHairLobes> turns{2 * material.tilt, -material.tilt,
                                              -4 * material.tilt, 0};
    for (int p = 0; p < kHairLobes; ++p)
        lobes[p] = {variances[p], -std::expm1(-2 / variances[p]), std::sin(turns[p]),
                    std::cos(turns[p])};
    constexpr float kLogisticOfNormal = 0.626657069f;  // sqrt(pi / 8)
    s = kLogisticOfNormal * (0.265f * n + 1.194f * n * n + 5.372f * power(n, 22));
    s_tail = 1 / (1 + std::exp(kPi / s));
}

HairBsdf::HairBsdf(const HairModel& model, const Vec3f& sigma_a, const Vec3f& wo, float h)
    : model_(&model) {
    const float sine_o = std::clamp(wo.x(), -1.0f, 1.0f);
    const float cosine_o = std::sqrt(1 - square(sine_o));
    const float gamma_o = std::asin(h);
    // The path inside a cylinder of index eta, seen at the inclination of wo: Bravais'
    // index eta' gives the refracted offset [Marschner et al. 2003, Sec. 4.3].
    const float sine_t = sine_o / model.eta, cosine_t = std::sqrt(1 - square(sine_t));
    const float sine_gamma_t =
        h * cosine_o / std::sqrt(square(model.eta) - square(sine_o));
    const float cosine_gamma_t = std::sqrt(1 - square(sine_gamma_t));
    const float gamma_t = std::asin(sine_gamma_t);
    const float length = 2 * cosine_gamma_t / cosine_t;  // in radii

    // A [Chiang et al. 2016, Eq. 11-12, residual from pbrt]. 1 - T f is taken apart so
    // that it keeps its digits where both near one; where f is one nothing enters.
    const float f =
        fresnel_dielectric(cosine_o * std::sqrt(std::max(0.0f, 1 - h * h)), model.eta);
    const float enters = std::max(0.0f, 1 - f);
    const Eigen::Array3f depth = sigma_a.array() * length;
    const Eigen::Array3f transmitted = (-depth).exp();
    lobes_[0].attenuation.setConstant(f);
    lobes_[1].attenuation = square(enters) * transmitted;
    lobes_[2].attenuation = f * lobes_[1].attenuation.array() * transmitted;
    lobes_[3].attenuation.setZero();
    if (enters > 0) {
        const Eigen::Array3f lost =
            depth.unaryExpr([](float x) { return -std::expm1(-x); });
        lobes_[3].attenuation =
            f * lobes_[2].attenuation.array() * transmitted / (enters + f * lost);
    }

    float total = 0;
    for (int p = 0; p < kHairLobes; ++p) {
        Lobe& lobe = lobes_[p];
        const HairModel::Lobe& turn = model.lobes[p];
        lobe.probability = luminance(lobe.attenuation);
        total += lobe.probability;
        lobe.sine = sine_o * turn.cosine + cosine_o * turn.sine;
        lobe.cosine = std::abs(cosine_o * turn.cosine - sine_o * turn.sine);
        // wo's azimuth is pi / 2 [Marschner et al. 2003, Eq. 3].
        lobe.phi = kPi / 2 + 2 * p * gamma_t - 2 * gamma_o + p * kPi;
    }
    for (Lobe& lobe : lobes_) lobe.probability /= total;
}

float HairBsdf::density(int lobe, float sine_i, float cosine_i, float phi) const {
    const Lobe& at = lobes_[lobe];
    const float n =
        lobe + 1 < kHairLobes ? azimuthal(wrapped(phi - at.phi), *model_) : 1 / (2 * kPi);
    return n * longitudinal(sine_i, cosine_i, at.sine, at.cosine, model_->lobes[lobe]);
}

float HairBsdf::lobe_density(int lobe, const Vec3f& wi) const {
    return density(lobe, std::clamp(wi.x(), -1.0f, 1.0f), std::hypot(wi.y(), wi.z()),
                   std::atan2(wi.z(), wi.y()));
}

BsdfValue HairBsdf::evaluate(const Vec3f& wi) const {
    const float sine_i = std::clamp(wi.x(), -1.0f, 1.0f);
    const float cosine_i = std::hypot(wi.y(), wi.z());
    const float phi = std::atan2(wi.z(), wi.y());
    BsdfValue at;
    for (int p = 0; p < kHairLobes; ++p) {
        const float mn = density(p, sine_i, cosine_i, phi);
        at.value += mn * lobes_[p].attenuation;
        at.pdf += mn * lobes_[p].probability;
    }
    return at;
}

std::optional<BsdfSample> HairBsdf::sample(float pick, float azimuth,
                                           const Vec2f& longitude) const {
    int p = 0;
    while (p + 1 < kHairLobes && pick >= lobes_[p].probability)
        pick -= lobes_[p++].probability;
    const Lobe& lobe = lobes_[p];
    const HairModel::Lobe& shape = model_->lobes[p];
    // M is sampled about the mirrored inclination [d'Eon et al. 2013, "Importance
    // Sampling for Physically-Based Hair Fiber Models"]; one minus the cosine keeps its
    // digits.
    const float versine =
        std::min(2.0f, -shape.variance * std::log1p(-shape.spread * longitude.x()));
    const float across = std::sqrt(versine * (2 - versine));
    const float sine_i =
        std::clamp(-(1 - versine) * lobe.sine +
                       across * std::cos(2 * kPi * longitude.y()) * lobe.cosine,
                   -1.0f, 1.0f);
    const float cosine_i = std::sqrt(1 - square(sine_i));
    const float phi = p + 1 < kHairLobes ? lobe.phi + sampled_azimuth(azimuth, *model_)
                                         : 2 * kPi * azimuth;
    BsdfSample sample;
    sample.direction = {sine_i, cosine_i * std::cos(phi), cosine_i * std::sin(phi)};
    sample.at = evaluate(sample.direction);
    if (!(sample.at.pdf > 0)) return std::nullopt;
    return sample;
}

}  // namespace lancret
