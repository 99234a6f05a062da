#pragma once
// The look of all strands of a groom: variation between strands and from root to tip.

#include <memory>
#include <vector>

#include "render_test/material/far_table.h"

namespace lancret {

/// The material of each strand. Absorption is linear from root to tip, as of pigments
/// that thin out evenly. Variation multiplies by a factor hashed from seed and strand,
/// uniform in 1 - v to 1 + v, so that the mean is that of the material.
class HairLook {
  public:
    /// The same for every strand.
    HairLook(HairModel model);  // NOLINT(google-explicit-constructor)
    /// Strands whose roughnesses are both at least `min_roughness` (0 to 1). It does not
    /// change absorption, even if that is set by a colour. Throws std::invalid_argument
    /// if a value is out of range.
    explicit HairLook(const HairMaterial& material, float min_roughness = 0);

    /// The lobes of a strand; with varied roughness, the nearest of 17 levels.
    const HairModel& model(std::uint32_t strand) const { return models_[level(strand)]; }
    /// That model averaged over the strand's width; built on first use.
    const FarTable& far_table(std::uint32_t strand) const {
        const std::size_t i = level(strand);
        return far_tables_->table(i, models_[i]);
    }
    /// Per radius; `along` is 0 at the root to 1 at the tip.
    Vec3f sigma_a(std::uint32_t strand, float along) const;
    /// Approximate colour of a dense groom of such strands.
    Vec3f colour(std::uint32_t strand, float along) const;

  private:
    std::size_t level(std::uint32_t strand) const;

    std::vector<HairModel> models_;                ///< from the smoothest to the roughest
    std::shared_ptr<const FarTables> far_tables_;  ///< [models]
    Vec3f root_, tip_;                             ///< absorption
    float melanin_variation_ = 0;
    float beta_n_ = 0.3f;
    std::uint64_t seed_ = 0;
};

}  // namespace lancret
