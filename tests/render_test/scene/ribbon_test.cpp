// Ribbons: strands with faces of their own.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "render_test/sampling/sampling.h"
#include "render_test/scene/scene_shape.h"
#include "render_test/trace/render.h"
#include "tests/render_test/make_curves.h"
#include "tests/render_test/random.h"
#include "tests/render_test/statistics.h"

namespace lancret {
namespace {

/// A strand along +x from 0 to 4 whose face looks along +z at x = 0 and turns about +x by
/// `turn` radian per cm.
Curves twisted(float radius, float turn) {
    Curves curves =
        curves_through({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}}, radius,
                       CurveShape::ribbon);
    curves.normals = Buffer<Point4f>(curves.points.size());
    for (std::size_t i = 0; i < curves.points.size(); ++i) {
        const float angle = turn * (float(i) - 1);
        curves.normals[i] = {0, -std::sin(angle), std::cos(angle), 0};
    }
    return curves;
}

Ray ray_along(const Vec3f& from, const Vec3f& direction) {
    Ray ray;
    ray.origin = from;
    ray.direction = direction.normalized();
    return ray;
}

TEST(Ribbon, IsHitAcrossItsWholeWidthOnBothSidesAndNotBeyond) {
    const float radius = 0.3f;
    const Curves curves = twisted(radius, 0);
    const HairScene scene(curves);
    for (int i = -49; i <= 49; ++i) {
        for (const float side : {1.0f, -1.0f}) {
            const float y = 0.01f * float(i);
            const auto hit =
                scene.intersect(ray_along({1.7f, y, 5 * side}, {0, 0, -side}));
            ASSERT_EQ(bool(hit), std::abs(y) < radius) << y;
            if (!hit) continue;
            EXPECT_TRUE(hit->strand.ribbon);
            EXPECT_NEAR(hit->position.z(), 0, 2e-3f * radius);
            EXPECT_NEAR(hit->shading_normal.z(), side, 1e-5);
            EXPECT_NEAR(hit->strand.along, 1.7f / 4, 1e-3);
        }
    }
    // A ribbon is invisible edge-on; a strand that faces the ray would be hit.
    EXPECT_FALSE(scene.intersect(ray_along({1.7f, 5, 0.01f}, {0, -1, 0})));
}

TEST(Ribbon, NormalTurnsWithItsFrame) {
    // The B-spline of the normals is their unit circle, shrunk by a constant factor, and
    // its angle leads by less than 0.05^3 between points. A twisted ribbon is a helicoid:
    // off the axis its normal leans by atan(0.05 y); on the axis, where these rays hit
    // it, it does not lean.
    const Curves curves = twisted(0.3f, 0.05f);
    const HairScene scene(curves);
    for (int i = 1; i < 40; ++i) {
        const float x = 0.1f * float(i), angle = 0.05f * x;
        const Vec3f normal(0, -std::sin(angle), std::cos(angle));
        for (const float side : {1.0f, -1.0f}) {
            const auto hit = scene.intersect(
                ray_along(Vec3f(x, 0, 0) + 3 * side * normal, -side * normal));
            ASSERT_TRUE(hit) << x;
            EXPECT_LT((hit->shading_normal - side * normal).norm(), 2e-3f) << x;
        }
    }
}

TEST(Ribbon, IsNotHitAgainByRaysThatLeaveIt) {
    const Curves curves = twisted(0.3f, 0.05f);
    const HairScene scene(curves);
    Random random{std::mt19937(4)};
    int tries = 0, again = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3f target(0.2f + 3.6f * random(), 0.56f * random() - 0.28f, 0);
        const Vec3f from(2, 2 * random() - 1, random() < 0.5f ? 6 : -6);
        const auto hit = scene.intersect(ray_along(from, target - from));
        if (!hit) continue;
        const Vec3f d = uniform_sphere(random.pair());
        // Rays along a helicoid hit it again: its curvature is 0.05 / cm.
        if (std::abs(d.dot(hit->shading_normal)) < 0.05f) continue;
        ++tries;
        again += scene.occluded(ray_from(*hit, hit->shading_normal, d, 0));
    }
    EXPECT_GT(tries, 10000);
    EXPECT_EQ(again, 0);
}

TEST(Ribbon, HitsHaveANormalBetweenTimesOfOppositeFaces) {
    // Halfway between the two times the faces cancel; before and after, the face is that
    // of the nearer time.
    const Curves from = twisted(0.3f, 0.05f);
    Curves to = twisted(0.3f, 0.05f);
    for (Point4f& n : to.normals.span()) n = {-n.x, -n.y, -n.z, 0};
    const HairScene scene(std::array{SceneTime{&from}, SceneTime{&to}});
    Random random{std::mt19937(6)};
    int sure = 0;
    for (const float time : {0.25f, 0.49999997f, 0.5f, 0.50000006f, 0.75f}) {
        for (int i = 0; i < 2000; ++i) {
            const Vec3f target(0.2f + 3.6f * random(), 0.5f * random() - 0.25f, 0);
            const Vec3f origin = target + 5 * uniform_sphere(random.pair());
            Ray ray = ray_along(origin, target - origin);
            ray.time = time;
            const auto hit = scene.intersect(ray);
            if (!hit) continue;
            ASSERT_TRUE(hit->position.allFinite());
            // Rounding of a few unit vectors.
            ASSERT_NEAR(hit->normal.norm(), 1, 1e-6) << time;
            ASSERT_NEAR(hit->shading_normal.norm(), 1, 1e-6) << time;
            ASSERT_LE(hit->shading_normal.dot(ray.direction), 1e-6f) << time;
            sure += time == 0.25f || time == 0.75f;
        }
    }
    EXPECT_GT(sure, 1000);
}

TEST(Ribbon, AHitWithoutANormalFacesTheRay) {
    const Curves curves = twisted(0.3f, 0);
    SceneShape shape;
    shape.curves = {&curves};
    const Ray ray = ray_along({1.5f, 0.1f, 5}, {0.1f, 0.2f, -1});
    for (const float none : {0.0f, 1e-30f, NAN, INFINITY}) {
        Hit hit;
        hit.primitive = 1, hit.u = 0.5f;
        hit.position = Vec3f(1.5f, 0.1f, 0);
        hit.normal = Vec3f(0, none, 0);
        shape.complete_strand(ray, hit);
        // The direction back along the ray, less its part along the strand (+x).
        const Vec3f facing = Vec3f(0, -0.2f, 1).normalized();
        EXPECT_LT((hit.normal - facing).norm(), 1e-6f) << none;
        EXPECT_LT((hit.shading_normal - facing).norm(), 1e-6f) << none;
    }
}

TEST(Ribbon, WhiteBladesInAnEvenSkyAreAsBrightAsTheSky) {
    std::vector<std::vector<Vec3f>> rows;
    Random random{std::mt19937(5)};
    for (int i = 0; i < 300; ++i) {
        const Vec3f root(6 * random(), 0, 6 * random());
        const Vec3f lean(2 * random() - 1, 0, 2 * random() - 1);
        rows.emplace_back();
        for (int j = 0; j <= 5; ++j) {
            const float s = float(j) / 5;
            rows.back().push_back(root + Vec3f(0, 3 * s, 0) + s * s * lean);
        }
    }
    Curves curves = curves_through(rows, 0.2f, CurveShape::ribbon);
    curves.normals = Buffer<Point4f>(curves.points.size());
    for (std::size_t i = 0; i < curves.points.size(); ++i) {
        const float a =
            float(i / curves.points_of(0)) + 0.1f * float(i % curves.points_of(0));
        curves.normals[i] = {std::cos(a), 0, std::sin(a), 0};
    }
    const HairScene geometry(curves);
    RenderScene scene;
    scene.geometry = &geometry;
    HairMaterial white;
    white.sigma_a = Vec3f::Zero();
    scene.hair = HairModel(white);
    scene.blade.translucency = 0.4f;
    scene.lights = Lights(Environment(Vec3f::Ones()));
    RenderSettings settings;
    settings.width = settings.height = 40;
    settings.samples = 128;
    settings.path.max_depth = 100000;
    const Image image = render(scene, framed(geometry.bounds(), {}), settings);
    Mean mean;
    for (const Eigen::Vector4f& pixel : image.rgba) {
        if (pixel.w() >= 0.5f) mean.add(pixel.x() / pixel.w());
    }
    EXPECT_GT(mean.count, 300);
    EXPECT_LT(mean.error(), 0.003);
    // Rounding: the colour without absorption is 1 to 1e-6 per bounce.
    EXPECT_NEAR(mean.value(), 1, kSigmas * mean.error() + 1e-5);
}

TEST(Ribbon, RefusesStrandsWithoutAFaceOrOfAnotherBasis) {
    Curves none =
        curves_through({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}, 0.1f, CurveShape::ribbon);
    EXPECT_THROW(HairScene{none}, std::invalid_argument);
    Curves hermite = curves_through({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}, 0.1f,
                                    CurveShape::ribbon, CurveBasis::hermite);
    hermite.normals = Buffer<Point4f>(hermite.points.size());
    for (Point4f& n : hermite.normals.span()) n = {0, 0, 1, 0};
    EXPECT_THROW(HairScene{hermite}, std::invalid_argument);
}

}  // namespace
}  // namespace lancret
