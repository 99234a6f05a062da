#pragma once
// Materials, viewers and random numbers for tests of the hair BSDF.

#include <random>

#include "render_test/hair_bsdf.h"

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

struct Random {
    std::mt19937 engine;
    float operator()() { return unit_float_of(engine()); }
    Vec2f pair() {
        const float x = (*this)();
        return {x, (*this)()};
    }
    static float unit_float_of(std::uint32_t bits) { return float(bits >> 8) * 0x1p-24f; }
};

inline std::optional<BsdfSample> draw(const HairBsdf& bsdf, Random& random) {
    const float pick = random(), azimuth = random();
    return bsdf.sample(pick, azimuth, random.pair());
}

}  // namespace lancret
