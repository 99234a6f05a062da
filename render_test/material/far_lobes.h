#pragma once
// How a strand too thin to be resolved scatters light: the mean of HairBsdf over the
// offset h (far_table.h). A flat strand is met at offsets uniform across it, so this is
// the exact mean of the near-field lobes, without the noise of h.

#include <optional>

#include "render_test/material/far_table.h"

namespace lancret {

/// The lobes at one hit; local axes and values as of HairBsdf.
class FarHairBsdf {
  public:
    /// `wo` is unit, with y = 0; `sigma_a` is per radius, finite and >= 0. Model and
    /// table must outlive it.
    FarHairBsdf(const HairModel& model, const FarTable& table, const Vec3f& sigma_a,
                const Vec3f& wo);

    BsdfValue evaluate(const Vec3f& wi) const;
    /// `pick` chooses the lobe; all in [0, 1). nullopt if the density underflows.
    std::optional<BsdfSample> sample(float pick, float azimuth,
                                     const Vec2f& longitude) const;

  private:
    friend struct LobeInspection;  // tests of single lobes

    BsdfValue evaluate(float sine_i, float cosine_i, float phi) const;
    float sampled_azimuth(int lobe, float pick, float random) const;
    FarTable::Node node(float phi) const;

    const HairModel* model_;
    const FarTable* table_;
    int row_;      ///< of cos(theta_o)
    float share_;  ///< 0..1, towards the next row
    TurnedInclination wo_;
    std::array<Eigen::Array4f, 3> once_, twice_;  ///< exp(-p a c_k) per channel
    std::array<Vec3f, kHairLobes> energy_;        ///< integrals over all directions
    Eigen::Array4f probability_;                  ///< of sampling each lobe
    Eigen::Array4f
        density_;  ///< `probability_` over the lobe's energy without absorption
};

}  // namespace lancret
