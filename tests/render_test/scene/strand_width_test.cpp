#include "render_test/scene/strand_width.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "render_test/sampling/sampling.h"
#include "render_test/trace/render.h"
#include "tests/render_test/make_curves.h"
#include "tests/render_test/scene/made_camera.h"
#include "tests/render_test/statistics.h"

namespace lancret {
namespace {

/// One strand of radius 0.5 cm from (x, -1, z) to (x, 1, z).
Curves strand_at(float x, float z) {
    std::vector<Vec3f> row;
    for (int j = 0; j <= 4; ++j) row.push_back(Vec3f(x, float(j) / 2 - 1, z));
    return curves_through({row}, 0.5f, CurveShape::flat, CurveBasis::bspline);
}

/// Whether the widest strand has this width, to a thousandth of a pixel.
testing::AssertionResult widest_is(float pixels, const Curves& curves,
                                   std::span<const Camera> cameras) {
    const bool above = any_wider(curves, cameras, 200, pixels - 1e-3f),
               below = !any_wider(curves, cameras, 200, pixels + 1e-3f);
    return above && below ? testing::AssertionSuccess()
                          : testing::AssertionFailure() << above << below;
}

TEST(StrandWidth, IsThatOfTheProjection) {
    const std::array cameras{made_camera()};
    // 1 cm of 40 cm in 200 pixels; twice that at half the distance.
    EXPECT_TRUE(widest_is(5, strand_at(0, 0), cameras));
    EXPECT_TRUE(widest_is(10, strand_at(0, 25), cameras));
}

TEST(StrandWidth, CountsInViewOfAnyCamera) {
    Camera other = made_camera();
    other.position.z() = 25;
    EXPECT_TRUE(widest_is(10, strand_at(0, 0), std::array{made_camera(), other}));
}

TEST(StrandWidth, DoesNotCountBehindTheCameraOrFarOutsideThePicture) {
    const std::array cameras{made_camera()};
    EXPECT_FALSE(any_wider(strand_at(0, 60), cameras, 200, 0));
    EXPECT_FALSE(any_wider(strand_at(31, 0), cameras, 200, 0));
    EXPECT_TRUE(any_wider(strand_at(29, 0), cameras, 200, 0));
}

/// A view into curls, with strands as wide as the widest that are drawn flat.
struct AtTheSwitch {
    static constexpr int kSize = 64;
    static constexpr float kRadius = 0.04f, kHigh = 2 * kRadius * kSize / kFlatPixels;
    TriangleMesh mesh = sphere_mesh(32, 16);
    RenderSettings settings;
    Camera camera = look_at(Vec3f(0, 8, 60), Vec3f(0, 8, 8), Vec3f::UnitY(),
                            2 * std::atan(kHigh / 2 / 52), 1);

    AtTheSwitch() {
        settings.width = settings.height = kSize;
        settings.samples = 64;
    }
    Image image(CurveShape shape, std::uint64_t seed) {
        const Curves curves = hairy_sphere(8000, 8, kRadius, 0.25f, shape);
        const HairScene geometry(curves, &mesh);
        RenderScene scene;
        scene.geometry = &geometry;
        scene.lights = default_lights(camera.view(), Vec3f::UnitY());
        settings.seed = seed;
        return render(scene, camera, settings);
    }
};

/// Luminance of squares of 8 x 8 pixels, which differ with their position in the picture.
Mean squares_of(const Image& image) {
    constexpr int kSquare = 8, kSize = AtTheSwitch::kSize;
    Mean out;
    for (int y = 0; y < kSize; y += kSquare) {
        for (int x = 0; x < kSize; x += kSquare) {
            double sum = 0;
            for (int j = 0; j < kSquare; ++j) {
                for (int i = 0; i < kSquare; ++i) {
                    sum += luminance(
                        image.rgba[std::size_t((y + j) * kSize + x + i)].head<3>());
                }
            }
            out.add(sum / (kSquare * kSquare));
        }
    }
    return out;
}

TEST(StrandWidth, TheSwitchFromFlatToRoundKeepsTheBrightness) {
    AtTheSwitch scene;
    const Mean flat = squares_of(scene.image(CurveShape::flat, 1));
    const Mean round = squares_of(scene.image(CurveShape::round, 2));
    // The noise of 4096 pixels of 64 samples is 0.6 %; side by side an eye distinguishes
    // 2 % (Weber's fraction).
    EXPECT_NEAR(round.value(), flat.value(), 0.02 * flat.value());
    // Light and shade do not move either: the contrast between squares is unchanged.
    EXPECT_NEAR(round.error(), flat.error(), 0.1 * flat.error());
}

}  // namespace
}  // namespace lancret
