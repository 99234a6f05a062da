#pragma once
// Materials and viewers for tests of the hair BSDF.

#include "render_test/material/hair_bsdf.h"
#include "tests/render_test/random.h"

namespace lancret {

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
