#pragma once
// A dull surface: the mesh under the strands.

#include <algorithm>
#include <cmath>
#include <optional>

#include "render_test/embree_scene.h"
#include "render_test/environment.h"
#include "render_test/hair_bsdf.h"
#include "render_test/sampling.h"

namespace lancret {

/// A dull surface, the same on both sides.
struct MeshMaterial {
    Vec3f colour = Vec3f(0.18f, 0.13f, 0.11f);  ///< share of light sent back, 0..1
    std::optional<ColourMap> texture;           ///< by UV, times `colour`
};

/// Nearest texel; UVs outside [0, 1] repeat, and v runs upward.
inline Vec3f texture_colour(const ColourMap& map, const Vec2f& uv) {
    const auto texel = [](float t, int size) {
        return std::clamp(int((t - std::floor(t)) * float(size)), 0, size - 1);
    };
    return map.at(texel(uv.x(), map.width), texel(1 - uv.y(), map.height));
}

/// The surface at one hit. Local axes: z the normal on the viewer's side. Values are BSDF
/// times cosine, as those of HairBsdf.
class Lambert {
  public:
    Lambert(const MeshMaterial& material, const Hit& hit) : colour_(material.colour) {
        if (material.texture)
            colour_ = colour_.cwiseProduct(texture_colour(*material.texture, hit.uv));
    }
    BsdfValue evaluate(const Vec3f& wi) const {
        if (wi.z() <= 0) return {};
        return {colour_ * (wi.z() / kPi), wi.z() / kPi};
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
