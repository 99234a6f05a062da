#pragma once
// A diffuse surface under a clear coat: skin, clothes, a plastic head.

#include "render_test/material/lambert.h"

namespace lancret {

inline constexpr float kCoatEta = 1.5f;  ///< index of refraction of a coat

/// The surface at one hit, of a material with a `coat_roughness`. Local axes and values
/// as of Lambert; `wo` points to the viewer, z >= 0. The coat is a dielectric of
/// index 1.5 with GGX facets [Walter et al. 2007] and height-correlated masking [Heitz
/// 2014]. Below it the colour scatters diffusely, times the light that enters and leaves
/// the coat, (1 - F(wo)) (1 - F(wi)). Reciprocal. Energy is lost, never gained: light
/// scattered twice by facets or reflected by the inside of the coat is ignored.
class Glossy {
  public:
    Glossy(const MeshMaterial& material, const Hit& hit, const Vec3f& wo);

    BsdfValue evaluate(const Vec3f& wi) const;
    std::optional<BsdfSample> sample(float pick, float, const Vec2f& random) const;

  private:
    Vec3f colour_, wo_;
    float alpha_;    ///< slope of facets: roughness squared
    float fresnel_;  ///< reflectance for wo
    float coat_;     ///< probability of sampling the coat
};

}  // namespace lancret
