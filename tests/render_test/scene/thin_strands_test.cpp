#include "render_test/scene/thin_strands.h"

#include <gtest/gtest.h>

#include "render_test/trace/render.h"
#include "tests/render_test/make_curves.h"
#include "tests/render_test/scene/made_camera.h"
#include "tests/render_test/statistics.h"

namespace lancret {
namespace {

constexpr int kHeight = 32;

/// Straight strands across the picture, slightly tilted to cross pixels at any offset.
Curves lines(float radius, CurveShape shape, CurveBasis basis, int count = 5) {
    std::vector<std::vector<Vec3f>> rows;
    for (int i = 0; i < count; ++i) {
        const float y = 30 * (float(i) + 0.5f) / float(count) - 15;
        std::vector<Vec3f> row;
        for (int j = 0; j <= 8; ++j) {
            const float x = float(8 * j - 32);
            row.push_back(Vec3f(x, y + 0.05f * x, 0));
        }
        rows.push_back(row);
    }
    return curves_through(rows, radius, shape, basis);
}

TEST(ThinStrands, AreWidenedToTheRequestedPixelsAndOthersAreNot) {
    Curves curves = lines(0.1f, CurveShape::flat, CurveBasis::bspline);
    const auto before = widen_thin_strands(curves, std::array{made_camera()}, kHeight, 2);
    ASSERT_EQ(before.size(), curves.points.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_EQ(before[i], 0.1f);
        EXPECT_NEAR(curves.points[i].w, 1.25f, 1e-5f);  // two pixels across
    }
    Curves thick = lines(2, CurveShape::flat, CurveBasis::bspline);
    widen_thin_strands(thick, std::array{made_camera()}, kHeight, 2);
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(thick.points[i].w, 2);
}

TEST(ThinStrands, TheNearestOfSeveralCamerasChooses) {
    Camera near = made_camera(), far = made_camera();
    far.position.z() = 500;
    Curves curves = lines(0.1f, CurveShape::flat, CurveBasis::bspline);
    widen_thin_strands(curves, std::array{far, near}, kHeight, 2);
    EXPECT_NEAR(curves.points[0].w, 1.25f, 1e-5f);
}

TEST(ThinStrands, BehindTheCameraAreUnchanged) {
    Camera camera = made_camera();
    camera.position.z() = -5;
    Curves curves = lines(0.1f, CurveShape::flat, CurveBasis::bspline);
    widen_thin_strands(curves, std::array{camera}, kHeight, 2);
    EXPECT_EQ(curves.points[0].w, 0.1f);
}

/// Mean coverage of a picture with strands widened to `pixels`, and its standard error,
/// over pictures of independent samples.
Mean coverage(Curves curves, float pixels, int pictures, int samples,
              const Vec3f& sky = Vec3f::Zero()) {
    const auto radii =
        widen_thin_strands(curves, std::array{made_camera()}, kHeight, pixels);
    HairSceneOptions options;
    if (pixels > 0) options.true_radii = radii;
    const HairScene geometry(curves, nullptr, options);
    RenderScene scene;
    scene.geometry = &geometry;
    HairMaterial white;
    white.sigma_a = Vec3f::Zero();
    scene.hair = HairLook(white);
    scene.lights = Lights(Environment(sky));
    RenderSettings settings;
    settings.width = settings.height = kHeight;
    settings.samples = samples;
    settings.path.max_depth = 1000;
    Mean mean;
    for (int i = 0; i < pictures; ++i) {
        settings.seed = std::uint64_t(i);
        double sum = 0;
        for (const auto& p : render(scene, made_camera(), settings).rgba) {
            sum += sky.x() > 0 ? p.x() : p.w();
        }
        mean.add(sum / (kHeight * kHeight));
    }
    return mean;
}

TEST(ThinStrands, CoverTheirTrueWidthInThePicture) {
    // Five strands of true width 0.2, 40 cm long within the picture, plus their tilt, in
    // 40 x 40 cm; they are drawn 2 pixels wide. A surface facing a ray that is inclined
    // to the view is stretched in the picture by 1 / cos: sqrt(1 + y^2 / 50^2), with y^2
    // that of the strand's middle plus 1 / 3 for its tilt.
    double expected = 0;
    for (const double y : {-12, -6, 0, 6, 12}) {
        expected += std::sqrt(1 + (y * y + 1 / 3.0) / 2500) * 40 * std::hypot(1, 0.05) *
                    0.2 / 1600;
    }
    for (const CurveShape shape : {CurveShape::flat, CurveShape::round}) {
        for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
            const Mean wide = coverage(lines(0.1f, shape, basis), 2, 16, 16);
            // The outline of the drawn tube is at asin(r / d), d = 50 r / 1.25: wider
            // than r / d by 1e-4; and the tilt turns the stretch by 0.05^2.
            EXPECT_NEAR(wide.value(), expected, kSigmas * wide.error() + 5e-4 * expected);
        }
    }
}

TEST(ThinStrands, HaveLessNoiseThanStrandsMetByChance) {
    const Curves thin = lines(0.02f, CurveShape::flat, CurveBasis::bspline);
    const Mean wide = coverage(lines(0.02f, CurveShape::flat, CurveBasis::bspline), 2, 24,
                               4),
               narrow = coverage(lines(0.02f, CurveShape::flat, CurveBasis::bspline), 0,
                                 24, 4);
    // Equal coverage, to the error of either.
    EXPECT_NEAR(wide.value(), narrow.value(),
                kSigmas * std::hypot(wide.error(), narrow.error()) + 5e-4 * wide.value());
    // A strand is drawn 31 times too wide: the binomial noise of coverage falls by the
    // root of that, 5.6. At least half of it is required, since 24 pictures estimate an
    // error to 15 %.
    EXPECT_LT(wide.error(), narrow.error() / 2.8);
}

TEST(ThinStrands, RaysThatLookThroughThemAreCounted) {
    Curves curves = lines(0.1f, CurveShape::flat, CurveBasis::bspline);
    HairSceneOptions options;
    const auto radii = widen_thin_strands(curves, std::array{made_camera()}, kHeight, 2);
    options.true_radii = radii;
    const HairScene geometry(curves, nullptr, options);
    RenderScene scene;  // nothing shines: no shadow rays
    scene.geometry = &geometry;
    std::vector<TracedRay> record;
    PathSettings settings;
    settings.max_depth = 1;
    settings.record = &record;
    const auto rays = [&](float y) {
        Ray ray;
        ray.origin = Vec3f(3, y, 10);
        ray.direction = -Vec3f::UnitZ();
        Sampler sampler(1, 0, 0);
        record.clear();
        return trace_path(scene, settings, ray, sampler).rays;
    };
    // Between two strands; then to a strand, to the one behind it, and the scattered ray.
    EXPECT_EQ(rays(3), 1u);
    EXPECT_EQ(rays(0.15f), 3u);
    EXPECT_EQ(record.size(), 3u);
}

TEST(ThinStrands, AWhiteGroomInAnEvenSkyIsAsBrightAsItsCoverage) {
    // First hits, shadow and bounce rays together: radiance is coverage times the sky.
    const Curves curves = hairy_sphere(800, 8, 0.05f);
    const auto copy = [&] { return hairy_sphere(800, 8, 0.05f); };
    const Mean light = coverage(copy(), 1, 8, 16, Vec3f::Ones());
    const Mean cover = coverage(copy(), 1, 8, 16);
    EXPECT_GT(cover.value(), 0.1);
    EXPECT_NEAR(light.value(), cover.value(),
                kSigmas * std::hypot(light.error(), cover.error()) + 1e-5);
}

TEST(ThinStrands, PassShadowRaysInProportionToTheirWidth) {
    // Parallel strands 1 cm apart, of true width 0.2 and drawn width 0.8: a fifth of the
    // perpendicular rays is blocked.
    std::vector<std::vector<Vec3f>> rows;
    for (int i = -20; i <= 20; ++i) {
        rows.push_back(
            {Vec3f(-30, float(i), 0), Vec3f(0, float(i), 0), Vec3f(30, float(i), 0)});
    }
    const Curves curves = curves_through(rows, 0.4f);
    const std::vector<float> radii(curves.points.size(), 0.1f);
    HairSceneOptions options;
    options.true_radii = radii;
    const HairScene geometry(curves, nullptr, options);
    Mean occluded, met;
    for (std::uint32_t i = 0; i < 40000; ++i) {
        Sampler sampler(1, i, 0);
        const Vec2f place = 20 * sampler.next() - Vec2f(10, 10);
        Ray ray;
        ray.origin = Vec3f(place.x(), place.y(), 30);
        ray.direction = -Vec3f::UnitZ();
        occluded.add(geometry.occluded(ray));
        met.add(geometry.intersect(ray).has_value());
    }
    EXPECT_NEAR(occluded.value(), 0.2, kSigmas * occluded.error());
    EXPECT_EQ(occluded.value(), met.value());  // the same ray has the same answer
}

TEST(ThinStrands, RefusesInvalidWidths) {
    Curves curves = lines(0.1f, CurveShape::flat, CurveBasis::bspline);
    EXPECT_THROW(widen_thin_strands(curves, {}, 0, 1), std::invalid_argument);
    EXPECT_THROW(widen_thin_strands(curves, {}, 10, -1), std::invalid_argument);
    EXPECT_THROW(widen_thin_strands(curves, {}, 10, NAN), std::invalid_argument);
    const std::vector<float> too_few(3);
    HairSceneOptions options;
    options.true_radii = too_few;
    EXPECT_THROW(HairScene(curves, nullptr, options), std::invalid_argument);
}

}  // namespace
}  // namespace lancret
