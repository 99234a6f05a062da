#pragma once
// The lights of a scene: an environment and any number of others.

#include <limits>
#include <variant>
#include <vector>

#include "render_test/light/environment.h"

namespace lancret {

/// A distant disc of uniform radiance, such as the sun.
struct DistantLight {
    Vec3f direction = Vec3f::UnitY();  ///< towards the light; any length but zero
    Vec3f irradiance = Vec3f::Ones();  ///< on a surface facing the light
    float angular_radius = 0.01f;      ///< radian, 0.0005 to 1.5; the sun's is 0.0047
};

/// A rectangle of uniform radiance that shines to the side of its normal.
struct RectangleLight {
    Vec3f centre = Vec3f::Zero();    ///< cm
    Vec3f normal = -Vec3f::UnitY();  ///< any length but zero
    Vec3f up = Vec3f::UnitZ();  ///< direction of the height, projected onto the plane
    Vec2f size = Vec2f::Constant(10);  ///< width, height; cm, above 0
    Vec3f radiance = Vec3f::Ones();
};

/// A sphere of uniform radiance that shines outward and inward.
struct SphereLight {
    Vec3f centre = Vec3f::Zero();  ///< cm
    float radius = 1;              ///< cm, above 0
    Vec3f radiance = Vec3f::Ones();
};

/// The lights of a scene. They do not occlude each other or anything else.
class Lights {
  public:
    /// Throws std::invalid_argument if a light is out of range.
    explicit Lights(Environment environment = Environment(),
                    const std::vector<DistantLight>& distant = {},
                    const std::vector<RectangleLight>& rectangles = {},
                    const std::vector<SphereLight>& spheres = {});

    /// Number of lights; number 0 is the environment.
    std::size_t size() const { return shapes_.size(); }

    /// A direction from a point (cm) to one light, with only that light's radiance and
    /// density. Density 0 if the light cannot be sampled from there.
    LightSample sample(std::size_t light, const Vec3f& from, const Vec2f& random) const;

    /// Sum of the radiance along a unit direction from lights up to `far` (cm; infinity
    /// for all), each times `weight(density of sampling that light in this direction)`.
    template <class Weight>
    Vec3f along(const Vec3f& from, const Vec3f& direction, float far,
                const Weight& weight) const {
        Vec3f sum = Vec3f::Zero();
        for (const Shape& shape : shapes_) {
            if (far < std::numeric_limits<float>::max() && is_far(shape)) continue;
            const LightSample met = meet(shape, from, direction);
            if (met.pdf > 0 && !(met.distance > far)) {
                sum += weight(met.pdf) * met.radiance;
            }
        }
        return sum;
    }
    /// As `along`, from all lights and unweighted.
    Vec3f radiance(const Vec3f& from, const Vec3f& direction) const;

    const Environment& environment() const;

    struct Disc {
        Mat3f frame;  ///< third column towards the light
        Vec3f radiance;
        float sine2;  ///< of the angular radius, squared
        float pdf;    ///< 1 / solid angle
    };
    struct Rectangle {
        Vec3f centre;  ///< cm
        Mat3f frame;   ///< columns: along the width, the height, the normal
        Vec2f half;    ///< cm
        Vec3f radiance;
    };
    using Shape = std::variant<Environment, Disc, Rectangle, SphereLight>;

  private:
    static bool is_far(const Shape& shape) { return shape.index() < 2; }
    static LightSample meet(const Shape& shape, const Vec3f& from,
                            const Vec3f& direction);

    std::vector<Shape> shapes_;  ///< the environment first
};

/// Lights that make strands readable: a key light above and to the left of the viewer, a
/// soft fill light from the right, a rim light from behind and a dim sky. `view` is the
/// unit viewing direction, `up` the up axis.
Lights default_lights(const Vec3f& view, const Vec3f& up);

}  // namespace lancret
