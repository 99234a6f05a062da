// Near- and far-field lobes on strands: the choice between them, and that both converge
// to the same picture where strands are not resolved.

#include <gtest/gtest.h>

#include "render_test/sampling/sampling.h"
#include "render_test/scene/camera.h"
#include "render_test/trace/integrator.h"
#include "tests/render_test/make_curves.h"
#include "tests/render_test/statistics.h"

namespace lancret {
namespace {

TEST(LobeWidth, FarShareFallsSmoothlyFromOneAtAPixelToZeroAtTwo) {
    EXPECT_EQ(far_share(0), 1);
    EXPECT_EQ(far_share(1), 1);
    EXPECT_EQ(far_share(1.5f), 0.5f);
    EXPECT_EQ(far_share(2), 0);
    EXPECT_EQ(far_share(100), 0);
    for (float x = 0; x < 3; x += 0.01f) {
        // The steepest slope of 3 x^2 - 2 x^3 is 3/2.
        EXPECT_LE(far_share(x + 0.01f), far_share(x));
        EXPECT_GE(far_share(x + 0.01f), far_share(x) - 0.0151f);
    }
}

/// Curls on a ball under a small sun and a sky.
struct Made {
    Curves curves;
    TriangleMesh mesh = sphere_mesh();
    HairScene geometry;
    RenderScene scene;

    Made(std::uint32_t strands, float radius, float eumelanin)
        : curves(hairy_sphere(strands, 6, radius)), geometry(curves, &mesh) {
        scene.geometry = &geometry;
        HairMaterial material;
        material.eumelanin = eumelanin;
        scene.hair = HairLook(material);
        scene.lights = Lights(Environment(Vec3f(0.3f, 0.4f, 0.5f)),
                              {{Vec3f(-0.5f, 0.7f, 0.6f), Vec3f(3, 2.9f, 2.6f), 0.05f}});
    }
};

/// Light of a square of the picture: the sum of its channels, over independent paths.
Mean radiance(const Made& made, const Vec2f& corner, float side,
              const PathSettings& settings, int count, std::uint32_t stream) {
    const Camera camera =
        look_at(Vec3f(0, 0, 60), Vec3f::Zero(), Vec3f::UnitY(), 0.5f, 1);
    Mean mean;
    for (int i = 0; i < count; ++i) {
        Sampler sampler(stream, std::uint32_t(i), 0);
        const Vec2f place = corner + side * sampler.next();
        sampler.skip_to(2);
        mean.add(
            trace_path(made.scene, settings, camera.ray(place), sampler).radiance.sum());
    }
    return mean;
}

TEST(LobeWidth, AutomaticIsFarOfThinStrandsAndNearOfWideOnes) {
    const Made made(300, 0.05f, 0.5f);
    // One scattering, so that only the camera's hit differs.
    PathSettings settings;
    settings.max_depth = 1;
    const auto of = [&](LobeWidth lobes, float pixel_angle) {
        settings.lobes = lobes, settings.pixel_angle = pixel_angle;
        return radiance(made, Vec2f(0.2f, 0.2f), 0.6f, settings, 2000, 7).sum;
    };
    const double near = of(LobeWidth::near, 0.01f), far = of(LobeWidth::far, 0.01f);
    EXPECT_NE(near, far);
    // Strands are 0.1 cm wide, 43 to 77 cm away: 0.0013 to 0.0024 radian.
    EXPECT_EQ(of(LobeWidth::automatic, 0.0025f), far);
    EXPECT_EQ(of(LobeWidth::automatic, 0.0006f), near);
    EXPECT_EQ(of(LobeWidth::automatic, 0), near);  // the size of a pixel is unset
    const double between = of(LobeWidth::automatic, 0.0014f);
    EXPECT_NE(between, near);
    EXPECT_NE(between, far);
}

TEST(LobeWidth, LaterScatteringsAreFarWhereLobesAreAutomatic) {
    const Made made(300, 0.05f, 0.5f);
    PathSettings settings;
    settings.lobes = LobeWidth::automatic, settings.pixel_angle = 1e-6f;
    const double automatic =
        radiance(made, Vec2f(0.2f, 0.2f), 0.6f, settings, 2000, 7).sum;
    settings.lobes = LobeWidth::near;
    EXPECT_NE(radiance(made, Vec2f(0.2f, 0.2f), 0.6f, settings, 2000, 7).sum, automatic);
}

/// Squares of a twelfth of the picture, which contain hundreds of strand widths: the
/// p-value of their differences under the hypothesis that only noise differs, and the
/// difference of the means over all.
struct Comparison {
    double chance, difference, error;
};
Comparison compare(const Made& made, int count) {
    PathSettings near, far;
    far.lobes = LobeWidth::far;
    double squares = 0, near_sum = 0, far_sum = 0, variance = 0;
    std::uint32_t stream = 0;
    int squares_count = 0;
    for (int y = 2; y < 10; y += 2) {
        for (int x = 2; x < 10; x += 2) {
            const Vec2f corner = Vec2f(float(x), float(y)) / 12;
            const Mean a = radiance(made, corner, 1.0f / 12, near, count, stream++);
            const Mean b = radiance(made, corner, 1.0f / 12, far, count, stream++);
            const double error = std::hypot(a.error(), b.error());
            squares += std::pow((a.value() - b.value()) / error, 2);
            near_sum += a.value(), far_sum += b.value(), variance += error * error;
            ++squares_count;
        }
    }
    return {chi_square_chance(squares, squares_count), far_sum / near_sum - 1,
            std::sqrt(variance) / near_sum};
}

TEST(LobeWidth, NearAndFarConvergeToTheSamePictureOfUnresolvedHair) {
    // Blond, brown and black. Wrong once in 300.
    for (const float eumelanin : {0.3f, 1.3f, 8.0f}) {
        const Made made(3000, 0.02f, eumelanin);
        const Comparison c = compare(made, 2500);
        EXPECT_GT(c.chance, 1e-3) << eumelanin << ' ' << c.difference;
        EXPECT_LT(c.error, 0.02);
    }
}

TEST(SlowLobeWidth, NearAndFarAgreeToAHalfPercentOfUnresolvedHair) {
    // Mean light of all squares. Wrong once in 1e5 each; the far field is allowed another
    // half percent for its tables.
    for (const float eumelanin : {0.3f, 1.3f, 8.0f}) {
        const Made made(20000, 0.006f, eumelanin);
        const Comparison c = compare(made, 100000);
        EXPECT_LT(c.error, 0.002) << eumelanin;
        EXPECT_LT(std::abs(c.difference), 0.005 + kSigmas * c.error) << eumelanin;
        RecordProperty("difference_" + std::to_string(int(10 * eumelanin)),
                       std::to_string(c.difference) + " +- " + std::to_string(c.error));
    }
}

}  // namespace
}  // namespace lancret
