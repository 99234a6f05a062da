#pragma once
// A leaf, a blade of grass or a feather's vane: thin, dull, and some light goes through.

#include "render_test/material/glossy.h"
#include "render_test/material/lambert.h"

namespace lancret {

/// What strands of shape `ribbon` are made of. Their colour is the groom's.
struct BladeMaterial {
    float translucency = 0.35f;           ///< share of the scattered light that goes
                                          ///< through, 0..1
    std::optional<float> coat_roughness;  ///< 0.05 to 1; none: no coat (glossy.h)
};

/// A blade at one hit: the same on both sides. Local axes: z the normal on the viewer's
/// side, where `wo` is (unit). Of its colour, all the light that it scatters, the share
/// `translucency` leaves on the far side and the rest on the viewer's, each with the
/// cosine; a coat reflects and lets light in and out on either side as Glossy's. Values
/// are BSDF times cosine. Without a coat they integrate to the colour; with one to less.
class Blade {
  public:
    Blade(const BladeMaterial& material, const Vec3f& colour, const Vec3f& wo);

    BsdfValue evaluate(const Vec3f& wi) const;
    /// `pick` chooses the side first.
    std::optional<BsdfSample> sample(float pick, float, const Vec2f& random) const;

  private:
    BsdfValue near_side(const Vec3f& wi) const;

    std::optional<Glossy> coated_;  ///< the viewer's side
    Vec3f near_, far_;              ///< the light that leaves on either
    float enters_ = 1;              ///< the share of wo's light that a coat lets in
    float far_chance_;              ///< of sampling the far side
};

}  // namespace lancret
