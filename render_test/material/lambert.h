#pragma once
// A dull surface: the mesh under the strands.

#include <algorithm>
#include <cmath>
#include <optional>

#include "render_test/light/environment.h"
#include "render_test/material/hair_bsdf.h"
#include "render_test/sampling/sampling.h"
#include "render_test/scene/embree_scene.h"

namespace lancret {

/// A dull surface, the same on both sides.
struct MeshMaterial {
    Vec3f colour = Vec3f(0.18f, 0.13f, 0.11f);  ///< share of light sent back, 0..1
    std::optional<Texture> texture;             ///< by UV, times `colour`
    std::optional<float> coat_roughness;        ///< 0.05 to 1; none: no coat (glossy.h)
};

/// Bilinear between texel centres; UVs outside [0, 1] repeat, and v runs upward.
inline Vec3f texture_colour(const Texture& map, const Vec2f& uv) {
    struct Pair {
        int low, high;
        float share;  ///< of the higher
    };
    const auto texels = [](float t, int size) -> Pair {
        const float x = (t - std::floor(t)) * float(size) - 0.5f;
        const int low = int(std::floor(x));
        return {(low + size) % size, (low + 1) % size, x - float(low)};
    };
    const Pair x = texels(uv.x(), map.width), y = texels(1 - uv.y(), map.height);
    const auto row = [&](int at) -> Vec3f {
        return (1 - x.share) * map.at(x.low, at) + x.share * map.at(x.high, at);
    };
    return (1 - y.share) * row(y.low) + y.share * row(y.high);
}

/// What the surface sends back at a hit.
inline Vec3f surface_colour(const MeshMaterial& material, const Hit& hit) {
    if (!material.texture) return material.colour;
    return material.colour.cwiseProduct(texture_colour(*material.texture, hit.uv));
}

/// The surface at one hit. Local axes: z the normal on the viewer's side. Values are BSDF
/// times cosine, as those of HairBsdf.
class Lambert {
  public:
    Lambert(const MeshMaterial& material, const Hit& hit)
        : colour_(surface_colour(material, hit)) {}
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
