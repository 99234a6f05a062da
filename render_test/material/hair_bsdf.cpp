#include "render_test/material/hair_bsdf.h"

#include <cmath>
#include <stdexcept>

#include "render_test/material/longitudinal.h"
#include "render_test/material/strand_section.h"
#include "render_test/sampling/sampling.h"

namespace lancret {
namespace {

// The lobes are one vector. Eigen's exponential is accurate to 2 units in the last place.
using Eigen::Array4f;
static_assert(kHairLobes == 4);

/// x to the power n, by squaring.
float power(float x, int n) {
    float result = 1;
    for (; n; n >>= 1, x *= x) {
        if (n & 1) result *= x;
    }
    return result;
}

/// N at angles within [-pi, pi]: the logistic of scale s, trimmed there [Chiang et al.
/// 2016, Eq. 8]; the residual's is even.
Array4f azimuthal(const Array4f& x, const HairModel& model) {
    const Array4f e = (-x.abs() / model.s).exp();
    Array4f n = e / (model.s * (1 - 2 * model.s_tail) * (1 + e).square());
    n[kHairLobes - 1] = 1 / (2 * kPif);
    return n;
}

float sampled_azimuth(float random, const HairModel& model) {
    const float p = model.s_tail + random * (1 - 2 * model.s_tail);
    return std::clamp(model.s * std::log(p / (1 - p)), -kPif, kPif);
}

/// Angles, reduced to [-pi, pi] by whole turns.
Array4f wrapped(const Array4f& angle) {
    return angle - 2 * kPif * (angle / (2 * kPif) + 0.5f).floor();
}

}  // namespace

HairModel::HairModel(const HairMaterial& material)
    : sigma_a(sigma_a_of(material)), eta(material.eta) {
    const float m = material.beta_m, n = material.beta_n;
    if (!(m >= 0.01f && m <= 1) || !(n >= 0.01f && n <= 1)) {
        throw std::invalid_argument("hair roughness must be within 0.01 and 1");
    }
    if (!(eta >= 1.01f && eta <= 5)) {
        throw std::invalid_argument("hair index of refraction must be within 1.01 and 5");
    }
    if (!(std::abs(material.tilt) <= 0.5f)) {
        throw std::invalid_argument("hair tilt must be within -0.5 and 0.5 radian");
    }
    // [Chiang et al. 2016, Eq. 7]: TT is half as wide as R, TRT and the rest twice.
    const float v = square(0.726f * m + 0.812f * m * m + 3.7f * power(m, 20));
    variance << v, v / 4, 4 * v, 4 * v;
    // Scales rise towards the tip, so their normals lean to the root. wo's inclination is
    // turned so that R shows at twice the tilt nearer the root, and TT and TRT nearer the
    // tip [Marschner et al. 2003, Sec. 4; angles as Chiang et al. 2016].
    const std::array<float, kHairLobes> turns{2 * material.tilt, -material.tilt,
                                              -4 * material.tilt, 0};
    for (int p = 0; p < kHairLobes; ++p) {
        spread[p] = -std::expm1(-2 / variance[p]);
        sine[p] = std::sin(turns[p]), cosine[p] = std::cos(turns[p]);
    }
    constexpr float kLogisticOfNormal = 0.626657069f;  // sqrt(pi / 8)
    s = kLogisticOfNormal * (0.265f * n + 1.194f * n * n + 5.372f * power(n, 22));
    s_tail = 1 / (1 + std::exp(kPif / s));
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

    // A [Chiang et al. 2016, Eq. 11-12, residual from pbrt]. 1 - T f is split so that it
    // keeps its digits if both are close to one; if f is one nothing enters.
    const float f =
        fresnel_dielectric(cosine_o * std::sqrt(std::max(0.0f, 1 - h * h)), model.eta);
    const float enters = std::max(0.0f, 1 - f);
    Array4f depth = Array4f::Zero();
    depth.head<3>() = sigma_a.array() * length;
    const Array4f transmitted = (-depth).exp();
    // 1 - exp(-d), by its series to 4e-8 where the difference loses digits.
    const Array4f lost =
        (depth < 0.01f)
            .select(depth * (1 - depth * (0.5f - depth * (1.0f / 6))), 1 - transmitted);
    const Array4f through = square(enters) * transmitted;
    const Array4f once = f * through * transmitted;
    attenuation_[0].setConstant(f);
    attenuation_[1] = through.head<3>();
    attenuation_[2] = once.head<3>();
    attenuation_[3].setZero();
    if (enters > 0) {
        attenuation_[3] = (f * once * transmitted / (enters + f * lost)).head<3>();
    }

    for (int p = 0; p < kHairLobes; ++p) probability_[p] = luminance(attenuation_[p]);
    probability_ /= probability_.sum();
    wo_ = turned_inclination(model, sine_o, cosine_o);
    // wo's azimuth is pi / 2 [Marschner et al. 2003, Eq. 3].
    const Array4f order(0, 1, 2, 3);
    phi_ = kPif / 2 - 2 * gamma_o + order * (2 * gamma_t + kPif);
}

HairBsdf::HairBsdf(const HairModel& model, const Vec3f& sigma_a, const Vec3f& wo, float h,
                   const StrandSection& section)
    : HairBsdf(model, sigma_a, wo, h) {
    if (section.aspect == 1) return;
    const float sine_o = std::clamp(wo.x(), -1.0f, 1.0f);
    const float cosine_o = std::max(1e-4f, std::sqrt(1 - square(sine_o)));
    const float bravais = std::sqrt(square(model.eta) - square(sine_o)) / cosine_o;
    const SectionPaths paths = section_paths(section, h, cosine_o, bravais, model.eta);
    const auto& f = paths.fresnel;
    const float enters = 1 - f[0];
    const float inverse_cosine = 1 / std::sqrt(1 - square(sine_o / model.eta));
    const auto transmitted = [&](float chord) -> Vec3f {
        return (-sigma_a.array() * chord * inverse_cosine).exp();
    };
    const Vec3f first = transmitted(paths.chord[0]), second = transmitted(paths.chord[1]);
    const Vec3f inside = enters * f[1] * first.cwiseProduct(second);
    attenuation_[0].setConstant(f[0]);
    attenuation_[1] = enters * (1 - f[1]) * first;
    attenuation_[2] = (1 - f[2]) * inside;
    // The light that stays inside continues as in a circle, with the first Fresnel term
    // and the last chord.
    attenuation_[3].setZero();
    if (enters > 0) {
        attenuation_[3] = (f[2] * inside.array() * enters * second.array() /
                           (enters + f[0] * (1 - second.array())))
                              .matrix();
    }
    for (int p = 0; p < kHairLobes; ++p) probability_[p] = luminance(attenuation_[p]);
    probability_ /= probability_.sum();
    for (int p = 0; p + 1 < kHairLobes; ++p) phi_[p] = paths.azimuth[p];
}

Array4f HairBsdf::densities(float sine_i, float cosine_i, float phi_i) const {
    return longitudinal(*model_, wo_, sine_i, cosine_i) *
           azimuthal(wrapped(phi_i - phi_), *model_);
}

BsdfValue HairBsdf::evaluate(const Vec3f& wi) const {
    return evaluate(std::clamp(wi.x(), -1.0f, 1.0f), length_across(wi),
                    std::atan2(wi.z(), wi.y()));
}

BsdfValue HairBsdf::evaluate(float sine_i, float cosine_i, float phi_i) const {
    const Array4f density = densities(sine_i, cosine_i, phi_i);
    BsdfValue out;
    for (int p = 0; p < kHairLobes; ++p) out.value += density[p] * attenuation_[p];
    out.pdf = (density * probability_).sum();
    return out;
}

std::optional<BsdfSample> HairBsdf::sample(float pick, float azimuth,
                                           const Vec2f& longitude) const {
    int p = 0;
    while (p + 1 < kHairLobes && pick >= probability_[p]) pick -= probability_[p++];
    const float sine_i = sampled_sine(*model_, wo_, p, longitude);
    const float cosine_i = std::sqrt(1 - square(sine_i));
    const float phi = p + 1 < kHairLobes ? phi_[p] + sampled_azimuth(azimuth, *model_)
                                         : 2 * kPif * azimuth;
    BsdfSample sample;
    sample.direction = {sine_i, cosine_i * std::cos(phi), cosine_i * std::sin(phi)};
    sample.at = evaluate(sine_i, cosine_i, phi);
    if (!(sample.at.pdf > 0)) return std::nullopt;
    return sample;
}

}  // namespace lancret
