#pragma once
// Light from all directions, infinitely far away.

#include <limits>
#include <vector>

#include "render_test/image/texture.h"

namespace lancret {

/// A direction to light, and the light from there.
struct LightSample {
    Vec3f direction = Vec3f::UnitY();  ///< unit, towards the light
    Vec3f radiance = Vec3f::Zero();
    float pdf = 0;                                            ///< 1/sr
    float distance = std::numeric_limits<float>::infinity();  ///< cm, along `direction`
};

/// A latitude-longitude map about an up axis, with its top row at the zenith. Radiance is
/// interpolated between texel centres. Sampling is proportional to the mean luminance of
/// a texel times its solid angle, and uniform within a texel.
class Environment {
  public:
    /// The same radiance everywhere.
    explicit Environment(const Vec3f& radiance = Vec3f::Zero());
    /// `up` points to the map's zenith; `rotation` (radian) rotates the map about it.
    /// Throws std::invalid_argument if the map is empty, negative or not finite.
    explicit Environment(Texture map, const Vec3f& up = Vec3f::UnitY(),
                         float rotation = 0);

    Vec3f radiance(const Vec3f& direction) const;
    float pdf(const Vec3f& direction) const;  ///< 1/sr
    LightSample sample(const Vec2f& random) const;
    /// Radiance and pdf along a direction, at little more than the cost of one.
    LightSample along(const Vec3f& direction) const;

  private:
    struct Place {
        float x, y;  ///< texels from the map's corner
    };
    Place place_of(const Vec3f& direction) const;
    Vec3f radiance(const Place& place) const;
    float pdf(const Place& place) const;
    float texel_pdf(int x, int y) const;

    Texture map_;
    Mat3f to_map_ = Mat3f::Identity();  ///< rows: the map's x, up, z
    std::vector<float> rows_;           ///< [height + 1] distribution over rows
    std::vector<float> columns_;        ///< [height * (width + 1)] within each row
    std::vector<float> edges_;  ///< [height + 1] cosine to the zenith, 1 down to -1
};

/// A smooth sky: `zenith` above, `horizon` around, `ground` below.
Texture sky_map(const Vec3f& zenith, const Vec3f& horizon, const Vec3f& ground);

}  // namespace lancret
