#pragma once
// Which light to look at. Every light is sampled, and one of the samples is chosen by
// what it would bring if nothing stood between [Talbot et al. 2005, "Importance
// Resampling for Global Illumination"]: of a path's costs, the shadow ray is the largest.

#include "render_test/light/lights.h"

namespace lancret {

struct ChosenLight {
    LightSample light;
    Vec3f brings = Vec3f::Zero();  ///< of all lights, if nothing stands between; zero
                                   ///< where there is none
};

/// `brings(sample)` is what a sample (density > 0) brings to `from`, divided by its
/// density. `pick` and both of `random` are uniform in [0, 1). The mean of what is chosen
/// is the sum over all lights.
template <class Brings>
ChosenLight choose_light(const Lights& lights, const Vec3f& from, float pick,
                         const Vec2f& random, const Brings& brings) {
    ChosenLight chosen;
    float sum = 0, own = 0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        // Each light's own pair: the first, shifted by Roberts's R2 sequence.
        const Vec2f shifted = random + float(i) * Vec2f(0.7548777f, 0.5698403f);
        const LightSample light =
            lights.sample(i, from, shifted - shifted.array().floor().matrix());
        if (!(light.pdf > 0) || !(light.radiance.maxCoeff() > 0)) continue;
        const Vec3f one = brings(light);
        const float weight = one.maxCoeff();
        if (!(weight > 0)) continue;
        sum += weight;
        const float chance = weight / sum;
        if (pick < chance) {
            chosen = {light, one};
            own = weight;
            pick /= chance;
        } else {
            pick = (pick - chance) / (1 - chance);
        }
    }
    if (own > 0) chosen.brings *= sum / own;
    return chosen;
}

}  // namespace lancret
