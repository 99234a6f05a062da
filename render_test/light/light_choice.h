#pragma once
// Which light to sample. Every light gets a sample, and one of them is chosen in
// proportion to its contribution if unoccluded [Talbot et al. 2005, "Importance
// Resampling for Global Illumination"]: the shadow ray is the most expensive part of a
// path.

#include "render_test/light/lights.h"

namespace lancret {

struct ChosenLight {
    LightSample light;
    Vec3f contribution = Vec3f::Zero();  ///< estimate for all lights if unoccluded; zero
                                         ///< if no light contributes
};

/// `contribution_of(sample)` is that of a sample (density > 0) at `from`, divided by its
/// density. `pick` and both of `random` are uniform in [0, 1). The mean of the chosen
/// contribution is the sum over all lights.
template <class ContributionOf>
ChosenLight choose_light(const Lights& lights, const Vec3f& from, float pick,
                         const Vec2f& random, const ContributionOf& contribution_of) {
    ChosenLight chosen;
    float sum = 0, chosen_weight = 0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        // A pair for each light: the first, shifted by Roberts's R2 sequence.
        const Vec2f shifted = random + float(i) * Vec2f(0.7548777f, 0.5698403f);
        const LightSample light =
            lights.sample(i, from, shifted - shifted.array().floor().matrix());
        if (!(light.pdf > 0) || !(light.radiance.maxCoeff() > 0)) continue;
        const Vec3f contribution = contribution_of(light);
        const float weight = contribution.maxCoeff();
        if (!(weight > 0)) continue;
        sum += weight;
        const float chance = weight / sum;
        if (pick < chance) {
            chosen = {light, contribution};
            chosen_weight = weight;
            pick /= chance;
        } else {
            pick = (pick - chance) / (1 - chance);
        }
    }
    if (chosen_weight > 0) chosen.contribution *= sum / chosen_weight;
    return chosen;
}

}  // namespace lancret
