#pragma once
// A diffuse surface: the mesh under the strands.

#include <optional>

#include "render_test/image/texture.h"
#include "render_test/material/bsdf.h"
#include "render_test/sampling/sampling.h"
#include "render_test/scene/hit.h"

namespace lancret {

/// The material of the mesh, equal on both sides.
struct MeshMaterial {
    Vec3f colour = Vec3f(0.18f, 0.13f, 0.11f);  ///< share of light reflected, 0..1
    std::optional<Texture> texture;             ///< by UV, multiplied by `colour`
    std::optional<float> coat_roughness;        ///< 0.05 to 1; unset: no coat (glossy.h)
};

/// The share of light reflected at a hit.
inline Vec3f surface_colour(const MeshMaterial& material, const Hit& hit) {
    if (!material.texture) return material.colour;
    return material.colour.cwiseProduct(texture_colour(*material.texture, hit.mesh.uv));
}

/// The diffuse surface at one hit. Local axes: z is the normal on the viewer's side.
/// Values are BSDF times cosine, as of HairBsdf.
class Lambert {
  public:
    Lambert(const MeshMaterial& material, const Hit& hit)
        : colour_(surface_colour(material, hit)) {}
    BsdfValue evaluate(const Vec3f& wi) const {
        if (wi.z() <= 0) return {};
        return {colour_ * (wi.z() / kPif), wi.z() / kPif};
    }
    std::optional<BsdfSample> sample(float, float, const Vec2f& random) const {
        BsdfSample sample;
        sample.direction = cosine_hemisphere(random);
        sample.at = evaluate(sample.direction);
        if (!(sample.at.pdf > 0)) return std::nullopt;
        return sample;
    }

  private:
    Vec3f colour_;
};

}  // namespace lancret
