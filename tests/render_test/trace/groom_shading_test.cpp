#include "render_test/trace/groom_shading.h"

#include <gtest/gtest.h>

#include "render_test/sampling/sampling.h"
#include "render_test/trace/integrator.h"
#include "tests/render_test/make_curves.h"
#include "tests/render_test/statistics.h"

namespace lancret {
namespace {

TEST(GroomShading, ScattersTheShareOfItsColour) {
    // By midpoints on 200 x 200 angles: the integrand is smooth, and their error 1e-4.
    double sum = 0;
    constexpr int kSteps = 200;
    for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
            const double t = M_PI * ((i + 0.5) / kSteps - 0.5),
                         a = 2 * M_PI * (j + 0.5) / kSteps;
            const Vec3f wi(float(std::sin(t)), float(std::cos(t) * std::cos(a)),
                           float(std::cos(t) * std::sin(a)));
            sum += groom_value(Vec3f::Constant(0.6f), wi).x() * std::cos(t);
        }
    }
    EXPECT_NEAR(sum * 2 * M_PI * M_PI / (kSteps * kSteps), 0.6, 1e-4);
}

/// A strand, half red and half green, lit from the viewer; `lid` hides half.
Mean shown(float x, int channel, bool lid) {
    std::vector<Vec3f> row;
    for (int i = 0; i <= 8; ++i) row.push_back(Vec3f(float(2 * i - 8), 0, 0));
    const Curves curves = curves_through({row}, 0.5f);
    TriangleMesh mesh;
    mesh.positions = {{-90, -90, 20}, {90, -90, 20}, {0, 180, 20}};
    mesh.triangles = {{0, 1, 2}};
    const HairScene geometry(curves, lid ? &mesh : nullptr);
    RenderScene scene;
    scene.geometry = &geometry;
    HairMaterial material;
    material.root_colour = Vec3f(0.9f, 0.1f, 0.1f);
    material.tip_colour = Vec3f(0.1f, 0.9f, 0.1f);
    scene.hair = HairLook(material);
    scene.lights = Lights(Environment(), {{Vec3f::UnitZ(), Vec3f::Ones(), 0.02f}});
    PathSettings settings;
    settings.groom_shading = true;
    Mean mean;
    for (std::uint32_t i = 0; i < 400; ++i) {
        Sampler sampler(1, i, 0);
        Ray ray;
        ray.origin = Vec3f(x, 0, 10);
        ray.direction = -Vec3f::UnitZ();
        const PathResult path = trace_path(scene, settings, ray, sampler);
        EXPECT_EQ(path.rays, 2u);  // to the strand, and on to the light
        mean.add(path.radiance[channel]);
    }
    return mean;
}

TEST(GroomShading, ShowsRootAndTipColourUnderALight) {
    // Along x from -8 (root) to 8 (tip), seen a hundredth from either end: absorption is
    // linear between those of 0.9 and 0.1. Light and view at right angles to the strand:
    // colour / pi^2 * 2 * E, with a disc of 0.02 radian that changes it by 1e-4.
    const Vec3f ends = sigma_a_of_colour(Vec3f(0.9f, 0.1f, 0.1f), 0.3f);
    const float along = 0.01f / 16;
    const float sigma = (1 - along) * ends.x() + along * ends.y();
    const double expected =
        colour_of_sigma_a(Vec3f::Constant(sigma), 0.3f).x() * 2 / (M_PI * M_PI);
    const Mean root = shown(-7.99f, 0, false), tip = shown(7.99f, 1, false);
    EXPECT_NEAR(root.value(), expected, 1e-3 * expected);
    EXPECT_NEAR(tip.value(), expected, 1e-3 * expected);
    const Mean dim = shown(-7.99f, 0, true);
    EXPECT_NEAR(dim.value(), kGroomShadowLight * expected, 1e-3 * expected);
}

}  // namespace
}  // namespace lancret
