#include "render_test/strand_width.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "render_test/render.h"
#include "render_test/sampling.h"
#include "tests/render_test/make_curves.h"

namespace lancret {
namespace {

/// One strand of radius 0.5 cm from (x, -1, z) to (x, 1, z).
Curves strand_at(float x, float z) {
    std::vector<Vec3f> row;
    for (int j = 0; j <= 4; ++j) row.push_back(Vec3f(x, float(j) / 2 - 1, z));
    return curves_through({row}, 0.5f, CurveShape::flat, CurveBasis::bspline);
}

/// From (0, 0, 50), a picture 40 cm high at the origin.
Camera made_camera() {
    return look_at(Vec3f(0, 0, 50), Vec3f::Zero(), Vec3f::UnitY(), 2 * std::atan(0.4f),
                   1);
}

TEST(StrandWidth, IsThatOfTheProjection) {
    const std::array cameras{made_camera()};
    // 1 cm of 40 cm in 200 pixels; at half the distance twice that.
    EXPECT_NEAR(widest_pixels(strand_at(0, 0), cameras, 200), 5, 1e-4);
    EXPECT_NEAR(widest_pixels(strand_at(0, 25), cameras, 200), 10, 1e-4);
}

TEST(StrandWidth, CountsInViewOfAnyCamera) {
    Camera other = made_camera();
    other.position.z() = 25;
    EXPECT_NEAR(widest_pixels(strand_at(0, 0), std::array{made_camera(), other}, 200), 10,
                1e-4);
}

TEST(StrandWidth, DoesNotCountBehindTheCameraOrFarOutsideThePicture) {
    const std::array cameras{made_camera()};
    EXPECT_EQ(widest_pixels(strand_at(0, 60), cameras, 200), 0);
    EXPECT_EQ(widest_pixels(strand_at(31, 0), cameras, 200), 0);
    EXPECT_GT(widest_pixels(strand_at(29, 0), cameras, 200), 0);
}

/// Curls as wide as the greatest that are drawn flat.
struct AtTheSwitch {
    static constexpr int kSize = 64;
    TriangleMesh mesh = sphere_mesh(32, 16);
    RenderSettings settings;
    Camera camera = look_at(Vec3f(0, 0, 60), Vec3f::Zero(), Vec3f::UnitY(),
                            2 * std::atan(0.3f), 1);  // 36 cm high

    AtTheSwitch() {
        settings.width = settings.height = kSize;
        settings.samples = 256;
    }
    Image image(CurveShape shape, std::uint64_t seed) {
        const float radius = 0.5f * kFlatPixels * 36 / kSize;
        const Curves curves = hairy_sphere(60, 8, radius, 0.25f, shape);
        const HairScene geometry(curves, &mesh);
        RenderScene scene;
        scene.geometry = &geometry;
        scene.lights = default_lights(camera.view(), Vec3f::UnitY());
        settings.seed = seed;
        return render(scene, camera, settings);
    }
};

/// Root mean square difference of the luminance of squares of 8 x 8 pixels, over the
/// mean.
double difference(const Image& a, const Image& b) {
    double squares = 0, sum = 0;
    constexpr int kSquare = 8, kSize = AtTheSwitch::kSize;
    for (int y = 0; y < kSize; y += kSquare)
        for (int x = 0; x < kSize; x += kSquare) {
            double apart = 0;
            for (int j = 0; j < kSquare; ++j)
                for (int i = 0; i < kSquare; ++i) {
                    const std::size_t pixel = std::size_t((y + j) * kSize + x + i);
                    const Vec3f one = a.rgba[pixel].head<3>(),
                                other = b.rgba[pixel].head<3>();
                    apart += luminance(one) - luminance(other);
                    sum += luminance(one);
                }
            squares += apart * apart;
        }
    constexpr double kSquares = double(kSize / kSquare) * (kSize / kSquare);
    return std::sqrt(squares / kSquares) / (sum / kSquares);
}

TEST(StrandWidth, TheSwitchFromFlatToRoundIsNotSeen) {
    AtTheSwitch scene;
    const Image flat = scene.image(CurveShape::flat, 1);
    const double noise = difference(flat, scene.image(CurveShape::flat, 2));
    const double change = difference(flat, scene.image(CurveShape::round, 3));
    RecordProperty("noise", std::to_string(noise));
    RecordProperty("change", std::to_string(change));
    std::printf("noise %.4f, change %.4f\n", noise, change);
    // What is left when the noise is taken out is below the two percent of luminance
    // that an eye tells apart side by side (Weber's fraction).
    EXPECT_LT(std::sqrt(std::max(0.0, change * change - noise * noise)), 0.02);
}

}  // namespace
}  // namespace lancret
