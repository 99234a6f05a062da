#pragma once
// Light from infinitely far, all around.

#include <limits>
#include <vector>

#include "render_test/image/texture.h"

namespace lancret {

/// A direction to light, and what comes from there.
struct LightSample {
    Vec3f direction = Vec3f::UnitY();  ///< unit, towards the light
    Vec3f radiance = Vec3f::Zero();
    float pdf = 0;                                            ///< 1/sr
    float distance = std::numeric_limits<float>::infinity();  ///< cm, along `direction`
};

/// A latitude-longitude map about an up axis, its top row at the zenith. Radiance is
/// interpolated between texel centres; sampling is proportional to each texel's mean
/// luminance times its solid angle, uniform within a texel.
class Environment {
  public:
    /// The same radiance everywhere.
    explicit Environment(const Vec3f& radiance = Vec3f::Zero());
    /// `up` is turned to the map's zenith; `rotation` (radian) turns the map about it.
    /// Throws std::invalid_argument where the map is empty, negative or not finite.
    explicit Environment(Texture map, const Vec3f& up = Vec3f::UnitY(),
                         float rotation = 0);

    Vec3f radiance(const Vec3f& direction) const;
    float pdf(const Vec3f& direction) const;  ///< 1/sr
    LightSample sample(const Vec2f& random) const;
    /// Both along a direction, for little more than one of them.
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
    std::vector<float> rows_;           ///< [height + 1] distribution of rows
    std::vector<float> columns_;        ///< [height * (width + 1)] within each row
    std::vector<float> edges_;  ///< [height + 1] cosine to the zenith, 1 down to -1
};

/// A smooth sky: `zenith` above, `horizon` around, `ground` below.
Texture sky_map(const Vec3f& zenith, const Vec3f& horizon, const Vec3f& ground);

}  // namespace lancret
