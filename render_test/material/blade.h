#pragma once
// A leaf, a blade of grass or the vane of a feather: thin, diffuse and translucent.

#include "render_test/material/glossy.h"
#include "render_test/material/lambert.h"

namespace lancret {

/// The material of strands of shape `ribbon`. Their colour is that of the hair.
struct BladeMaterial {
    float translucency = 0.35f;           ///< share of scattered light that is
                                          ///< transmitted, 0..1
    std::optional<float> coat_roughness;  ///< 0.05 to 1; unset: no coat (glossy.h)
};

/// A blade at one hit, equal on both sides. Local axes: z is the normal on the viewer's
/// side, where `wo` (unit) is. Its colour is the scattered light: the share
/// `translucency` leaves on the far side and the rest on the viewer's side, both
/// diffusely. A coat reflects and transmits on both sides like that of Glossy. Values are
/// BSDF times cosine. They integrate to the colour without a coat, and to less with one.
class Blade {
  public:
    Blade(const BladeMaterial& material, const Vec3f& colour, const Vec3f& wo);

    BsdfValue evaluate(const Vec3f& wi) const;
    /// `pick` chooses the side, then a lobe of the coated side; all in [0, 1).
    std::optional<BsdfSample> sample(float pick, float, const Vec2f& random) const;

  private:
    BsdfValue near_side(const Vec3f& wi) const;

    std::optional<Glossy> coated_;  ///< the viewer's side
    Vec3f near_, far_;              ///< scattered light per side
    float enters_ = 1;              ///< share of light from wo that a coat transmits
    float far_chance_;              ///< probability of sampling the far side
};

}  // namespace lancret
