#pragma once
// Everything that shines: an environment and any number of distant lights, sampled as
// one.

#include <vector>

#include "render_test/environment.h"

namespace lancret {

/// A far disc of even radiance, such as the sun.
struct DistantLight {
    Vec3f direction = Vec3f::UnitY();  ///< towards the light; any length but zero
    Vec3f irradiance = Vec3f::Ones();  ///< on a surface that faces it
    float angular_radius = 0.01f;      ///< radian, 0.0005 to 1.5; the sun's is 0.0047
};

/// The lights of a scene as one: radiance is the sum of all, and the density of `sample`
/// is the mean of each light's own, weighted by what it sends.
class Lights {
  public:
    /// Throws std::invalid_argument where a light is out of its range.
    explicit Lights(Environment environment = Environment(),
                    const std::vector<DistantLight>& distant = {});

    Vec3f radiance(const Vec3f& direction) const;
    float pdf(const Vec3f& direction) const;  ///< 1/sr
    /// `pick` chooses the light. Density 0 where there is no light at all.
    LightSample sample(float pick, const Vec2f& random) const;
    /// radiance and pdf along a direction.
    LightSample along(const Vec3f& direction) const;
    const Environment& environment() const { return environment_; }

  private:
    struct Disc {
        Mat3f frame;  ///< third column towards the light
        Vec3f radiance;
        float sine2;  ///< of the angular radius, squared
        float pdf;    ///< 1 / solid angle
        float share;  ///< of the samples
        bool holds(const Vec3f& direction) const;
    };
    Environment environment_;
    float environment_share_ = 0;
    std::vector<Disc> discs_;
};

/// Light that makes strands readable: a key above and to the left of the viewer, a rim
/// from behind, a soft sky. `view` is the unit direction of sight, `up` the up axis.
Lights default_lights(const Vec3f& view, const Vec3f& up);

}  // namespace lancret
