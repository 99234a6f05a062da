// Ray hits on strands of elliptic section.

#include <gtest/gtest.h>

#include "render_test/trace/render.h"
#include "tests/render_test/make_curves.h"
#include "tests/render_test/statistics.h"

namespace lancret {
namespace {

/// A strand along +x, x = 0 to 4, with its face, the minor axis, along +z.
Curves with_face(float radius) {
    Curves curves =
        curves_through({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}}, radius);
    curves.normals = Buffer<Point4f>(curves.points.size());
    for (Point4f& n : curves.normals.span()) n = {0, 0, 1, 0};
    return curves;
}

TEST(EllipticStrands, AreAsWideAsTheirSectionShows) {
    const float radius = 0.1f, aspect = 0.6f;
    const Curves curves = with_face(radius);
    const HairScene scene(curves, nullptr, {.aspect = aspect});
    for (int turn = 0; turn < 24; ++turn) {
        const float a = 0.2618f * float(turn);
        const Vec3f back(0, std::sin(a), std::cos(a)), side(0, std::cos(a), -std::sin(a));
        // Half of the visible width: the support of the ellipse along `side`.
        const float half = radius * std::hypot(std::cos(a), aspect * std::sin(a));
        for (const float h : {-1.02f, -0.98f, -0.4f, 0.0f, 0.7f, 0.98f, 1.02f}) {
            Ray ray;
            ray.origin = Vec3f(1.7f, 0, 0) + 5 * back + h * half * side;
            ray.direction = -back;
            const auto hit = scene.intersect(ray);
            ASSERT_EQ(bool(hit), std::abs(h) < 1) << turn << ' ' << h;
            EXPECT_EQ(scene.occluded(ray), bool(hit));
            if (!hit) continue;
            // facing = back, tangent = +x: facing x tangent is (0, cos a, -sin a).
            // Positions near 5 cm are accurate to 6e-7, over a half width of at least
            // 0.06, doubled.
            EXPECT_NEAR(hit->strand.h, h, 2e-5) << turn;
            EXPECT_EQ(hit->strand.section.aspect, aspect);
            // The major axis is +-y, at angle a from `side` towards `back`, of either
            // sign.
            EXPECT_NEAR(std::sin(hit->strand.section.angle - a), 0, 1e-5) << turn;
        }
    }
}

TEST(EllipticStrands, WhiteOnesInAnEvenSkyAreAsBrightAsTheSky) {
    Curves curves = hairy_sphere(4000, 8, 0.03f);
    curves.normals = Buffer<Point4f>(curves.points.size());
    for (std::size_t i = 0; i < curves.points.size(); ++i) {
        const float a = 0.3f * float(i);
        curves.normals[i] = {std::cos(a), 0.3f, std::sin(a), 0};
    }
    const HairScene geometry(curves, nullptr, {.aspect = 0.5f});
    RenderScene scene;
    scene.geometry = &geometry;
    HairMaterial white;
    white.sigma_a = Vec3f::Zero();
    scene.hair = HairModel(white);
    scene.lights = Lights(Environment(Vec3f::Ones()));
    RenderSettings settings;
    settings.width = settings.height = 40;
    settings.samples = 24;
    settings.path.max_depth = 100000;
    const Image image = render(scene, framed(geometry.bounds(), {}), settings);
    Mean mean;
    for (const Eigen::Vector4f& pixel : image.rgba) {
        if (pixel.w() >= 0.5f) mean.add(pixel.x() / pixel.w());
    }
    EXPECT_GT(mean.count, 300);
    EXPECT_LT(mean.error(), 0.005);
    EXPECT_NEAR(mean.value(), 1, kSigmas * mean.error() + 1e-5);
}

TEST(EllipticStrands, RefusesRoundStrandsAndThoseWithoutAFace) {
    const Curves flat = curves_through({{{0, 0, 0}, {1, 0, 0}}}, 0.1f);
    EXPECT_THROW(HairScene(flat, nullptr, {.aspect = 0.5f}), std::invalid_argument);
    const Curves face = with_face(0.1f);
    for (const float aspect : {0.0f, -1.0f, 1.5f, NAN}) {
        EXPECT_THROW(HairScene(face, nullptr, {.aspect = aspect}), std::invalid_argument);
    }
}

}  // namespace
}  // namespace lancret
