#pragma once
// The material of a whole groom: how its strands differ, and how each changes from root
// to tip.

#include <memory>
#include <vector>

#include "render_test/material/far_lobes.h"

namespace lancret {

/// What each strand of a material is. Absorption is linear from root to tip: that of
/// pigments which thin out evenly. A strand's own share of the variation is a hash of
/// seed and strand: 1 - v to 1 + v times, evenly, so that the mean is the material's.
class HairLook {
  public:
    /// Every strand alike.
    HairLook(HairModel model);  // NOLINT(google-explicit-constructor)
    /// Strands of which both roughnesses are at least `least_roughness` (0 to 1). They
    /// absorb as without it, even where a colour was given. Throws std::invalid_argument
    /// where a value is out of its range.
    explicit HairLook(const HairMaterial& material, float least_roughness = 0);

    /// The strand's lobes; of 17 roughnesses, the strand's own or the nearest.
    const HairModel& model(std::uint32_t strand) const { return models_[level(strand)]; }
    /// That model averaged over the strand's width.
    const FarTable& far_table(std::uint32_t strand) const {
        const std::size_t at = level(strand);
        return far_tables_->table(at, models_[at]);
    }
    /// Per radius; `along` goes from 0 at the root to 1 at the tip.
    Vec3f sigma_a(std::uint32_t strand, float along) const;
    /// What a dense groom of such strands shows, about.
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
