#pragma once
// Materials and viewers for tests of the hair BSDF.

#include "render_test/material/far_lobes.h"
#include "render_test/material/longitudinal.h"
#include "tests/render_test/random.h"

namespace lancret {

/// Single lobes of a BSDF.
struct LobeInspection {
    /// M N, which integrates to one over the sphere.
    static float density(const HairBsdf& bsdf, int lobe, const Vec3f& wi) {
        return bsdf.densities(std::clamp(wi.x(), -1.0f, 1.0f), length_across(wi),
                              std::atan2(wi.z(), wi.y()))[lobe];
    }
    static Vec3f attenuation(const HairBsdf& bsdf, int lobe) {
        return bsdf.attenuation_[lobe];
    }
    /// Share of samples.
    static float probability(const HairBsdf& bsdf, int lobe) {
        return bsdf.probability_[lobe];
    }
    /// Share of light, over all directions.
    static Vec3f energy(const FarHairBsdf& bsdf, int lobe) { return bsdf.energy_[lobe]; }
};

inline Vec3f viewer(float inclination) {
    return {std::sin(inclination), 0, std::cos(inclination)};
}

inline HairMaterial material(float beta_m, float beta_n, float tilt, float sigma_a) {
    HairMaterial m;
    m.beta_m = beta_m, m.beta_n = beta_n, m.tilt = tilt;
    m.sigma_a = Vec3f::Constant(sigma_a);
    return m;
}

inline std::optional<BsdfSample> draw(const HairBsdf& bsdf, Random& random) {
    const float pick = random(), azimuth = random();
    return bsdf.sample(pick, azimuth, random.pair());
}

}  // namespace lancret
