// Sampling lights, sampling the material, and both combined give the same picture.

#include <gtest/gtest.h>

#include "render_test/trace/integrator.h"
#include "tests/render_test/make_curves.h"
#include "tests/render_test/statistics.h"

namespace lancret {
namespace {

/// A few thick strands over a ball.
struct Made {
    Curves curves = hairy_sphere(60, 6, 0.4f);
    TriangleMesh mesh = sphere_mesh();
    HairScene geometry{curves, &mesh};
    RenderScene scene;

    explicit Made(Lights lights) {
        scene.geometry = &geometry;
        HairMaterial material;
        material.eumelanin = 0.3f;
        material.beta_m = material.beta_n = 0.5f;
        scene.hair = HairLook(material);
        scene.mesh.colour = Vec3f(0.8f, 0.5f, 0.3f);
        scene.lights = std::move(lights);
    }
};

Mean radiance(const RenderScene& scene, const Ray& ray, LightSampling sampling,
              std::uint32_t stream) {
    PathSettings settings;
    settings.max_depth = 3;
    settings.sampling = sampling;
    Mean mean;
    for (std::uint32_t i = 0; i < 12000; ++i) {
        // The samples of one pixel depend on each other; pixels are independent.
        Sampler sampler(stream, i, 0);
        mean.add(trace_path(scene, settings, ray, sampler).radiance.x());
    }
    return mean;
}

void compare_samplings(Lights lights) {
    const Made made(std::move(lights));
    double squares = 0;
    int tests = 0;
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 5; ++x) {
            Ray ray;
            ray.origin = Vec3f(3.1f * float(x - 2), 3.3f * float(y - 2), 40);
            ray.direction = -Vec3f::UnitZ();
            const std::uint32_t stream = std::uint32_t(3 * (5 * y + x));
            const Mean both = radiance(made.scene, ray, LightSampling::both, stream);
            for (const LightSampling one :
                 {LightSampling::lights, LightSampling::scattering}) {
                const Mean other =
                    radiance(made.scene, ray, one, stream + 1 + std::uint32_t(one));
                const double error = std::hypot(both.error(), other.error());
                if (error == 0) {
                    EXPECT_EQ(both.value(), other.value());
                    continue;
                }
                const double z = (both.value() - other.value()) / error;
                EXPECT_LT(std::abs(z), 5) << x << ' ' << y;
                squares += z * z;
                ++tests;
            }
        }
    }
    // The pairs at one pixel share `both`, so their z are correlated by at most a half,
    // and the sum of squares has twice the variance of a chi-square. Its p-value,
    // computed with half as many degrees of freedom, is wrong at most once in 1e4.
    ASSERT_GT(tests, 30);
    EXPECT_GT(chi_square_chance(squares / 2, tests / 2.0), 1e-4)
        << squares << ' ' << tests;
}

TEST(LightSampling, EnvironmentIsTheSameByEitherWayAndBoth) {
    compare_samplings(Lights(Environment(
        sky_map(Vec3f(3, 1, 1), Vec3f(0.2f, 0.3f, 0.5f), Vec3f(0.1f, 0, 0)))));
}

TEST(LightSampling, DistantLightIsTheSameByEitherWayAndBoth) {
    compare_samplings(
        Lights(Environment(), {{Vec3f(1, 2, 2), Vec3f::Constant(3), 0.6f}}));
}

TEST(LightSampling, RectangleIsTheSameByEitherWayAndBoth) {
    RectangleLight light;
    light.centre = Vec3f(-12, 12, 20);
    light.normal = Vec3f(12, -12, -20);
    light.size = Vec2f(22, 14);
    light.radiance = Vec3f::Constant(5);
    compare_samplings(Lights(Environment(), {}, {light}));
}

TEST(LightSampling, SphereIsTheSameByEitherWayAndBoth) {
    compare_samplings(
        Lights(Environment(), {}, {}, {{Vec3f(10, 12, 18), 8, Vec3f::Constant(5)}}));
}

TEST(LightSampling, ALightWithinTheGroomIsTheSameByEitherWayAndBoth) {
    // Among the strands, and in front of some: distances to lights matter.
    compare_samplings(Lights(Environment(Vec3f::Constant(0.2f)), {}, {},
                             {{Vec3f(0, 0, 12), 2.5f, Vec3f::Constant(5)}}));
}

TEST(LightSampling, AStrandBeyondALightDoesNotShadeIt) {
    // A plate, a ball of light above it, and a plate above both that occludes nothing.
    TriangleMesh plates;
    for (const float z : {0.0f, 10.0f}) {
        for (const Vec3f& p : {Vec3f(-90, -90, z), Vec3f(90, -90, z), Vec3f(0, 180, z)}) {
            plates.positions.push_back(p);
        }
    }
    plates.triangles = {{0, 1, 2}, {3, 4, 5}};
    const Curves none = curves_through({}, 0.1f);
    const HairScene geometry(none, &plates);
    RenderScene scene;
    scene.geometry = &geometry;
    scene.mesh.colour = Vec3f::Ones();
    scene.lights = Lights(Environment(), {}, {}, {{Vec3f(0, 0, 5), 1, Vec3f::Ones()}});
    Ray ray;
    ray.origin = Vec3f(1, 0, 8);
    ray.direction = Vec3f(-1, 0, -8).normalized();
    PathSettings settings;
    settings.max_depth = 1;
    for (const LightSampling sampling :
         {LightSampling::both, LightSampling::lights, LightSampling::scattering}) {
        settings.sampling = sampling;
        Mean mean;
        for (std::uint32_t i = 0; i < 20000; ++i) {
            Sampler sampler(3, i, 0);
            mean.add(trace_path(scene, settings, ray, sampler).radiance.x());
        }
        // Straight below a sphere: E = pi L (r / d)^2, and a white plate shows E / pi.
        EXPECT_NEAR(mean.value(), 1 / 25.0, kSigmas * mean.error() + 1e-6);
    }
}

}  // namespace
}  // namespace lancret
