#pragma once
// A dull surface under a clear coat: skin, clothes, a head of plastic.

#include "render_test/material/lambert.h"

namespace lancret {

inline constexpr float kCoatEta = 1.5f;  ///< index of refraction of a coat

/// The surface at one hit, of a material with a `coat_roughness`. Local axes and values
/// as Lambert's; `wo` points to the viewer, z >= 0. The coat is a dielectric of index 1.5
/// with GGX facets [Walter et al. 2007] and height-correlated masking [Heitz 2014]; under
/// it the colour scatters what the coat lets in and out, (1 - F(wo)) (1 - F(wi)) of it.
/// Reciprocal. It never sends on more than it receives; what facets scatter twice and
/// what the coat's inside sends back is lost.
class Glossy {
  public:
    Glossy(const MeshMaterial& material, const Hit& hit, const Vec3f& wo);

    BsdfValue evaluate(const Vec3f& wi) const;
    std::optional<BsdfSample> sample(float pick, float, const Vec2f& random) const;

  private:
    Vec3f colour_, wo_;
    float alpha_;    ///< the slope of facets: roughness squared
    float fresnel_;  ///< of wo at the surface
    float coat_;     ///< the share of samples that the coat gets
};

}  // namespace lancret
