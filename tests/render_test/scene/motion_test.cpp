#include "render_test/scene/motion.h"

#include <gtest/gtest.h>

#include <array>

#include "render_test/trace/render.h"
#include "tests/render_test/make_curves.h"

namespace lancret {
namespace {

TEST(Camera, APointIsWhereItsRayShowsIt) {
    Camera camera = look_at({3, 4, 40}, {1, 0, 2}, Vec3f::UnitY(), 0.8f, 1.6f);
    for (const Vec2f& place : {Vec2f(0.1f, 0.9f), Vec2f(0.5f, 0.5f), Vec2f(1.2f, 0.3f)}) {
        const Ray ray = camera.ray(place);
        const auto found = camera.place_of(ray.origin + 17 * ray.direction);
        ASSERT_TRUE(found);
        // Positions of up to 50 cm, rounded to 4e-6, in a picture 12 cm high.
        EXPECT_LT((*found - place).norm(), 4e-6f);
    }
    EXPECT_FALSE(camera.place_of(camera.position - camera.view()));
}

/// Two upright strands 10 cm in front of a camera, and a wall behind them; everything
/// moves.
struct Moving {
    Curves first, last;
    TriangleMesh wall, wall_after;
    Camera camera = look_at({0, 0, 10}, {0, 0, 0}, Vec3f::UnitY(), 1, 1);

    explicit Moving(const Vec3f& way) {
        first = strands(Vec3f::Zero());
        last = strands(way);
        wall.positions = {{-50, -50, -5}, {50, -50, -5}, {0, 80, -5}};
        wall.triangles = {{0, 1, 2}};
        wall_after = wall;
        for (Vec3f& p : wall_after.positions) p += way;
    }
    static Curves strands(const Vec3f& way) {
        std::vector<std::vector<Vec3f>> rows(2);
        for (int i = 0; i < 2; ++i) {
            for (int j = -4; j <= 4; ++j) {
                rows[i].push_back(Vec3f(float(2 * i - 1), float(j), 0) + way);
            }
        }
        return curves_through(rows, 0.5f);
    }
    Image image(bool moves) const {
        const std::array<SceneTime, 2> times{SceneTime{&first, &wall},
                                             SceneTime{&last, &wall_after}};
        const auto used = std::span(times).first(moves ? 2 : 1);
        const HairScene geometry(used);
        RenderScene scene;
        scene.geometry = &geometry;
        scene.times = used;
        scene.lights = default_lights(camera.view(), Vec3f::UnitY());
        RenderSettings settings;
        settings.width = settings.height = 20;
        settings.samples = 16;
        settings.channels.motion = true;
        return render(scene, camera, settings);
    }
};

TEST(Motion, IsThatOfTheClosedFormOfAStepAcrossThePicture) {
    // 20 pixels show 2 * 10 * tan(0.5) cm at the strands, and 3/2 of it at the wall.
    const Vec3f way(0.5f, 0.25f, 0);
    const Image image = Moving(way).image(true);
    const float pixels_per_cm = 1 / std::tan(0.5f);
    int strands = 0, walls = 0;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        if (image.id[i] == kNothingId) continue;
        // Only pixels that see a single object, identified by their mean tangent.
        const float strand = image.tangent[i].norm();
        if (strand != 0 && strand < 0.9999f) continue;
        const float scale = strand > 0 ? pixels_per_cm : pixels_per_cm * 2 / 3;
        EXPECT_NEAR(image.motion[i].x(), scale * way.x(), 2e-5f);
        EXPECT_NEAR(image.motion[i].y(), scale * way.y(), 2e-5f);
        (strand > 0 ? strands : walls) += 1;
    }
    EXPECT_GT(strands, 4);
    EXPECT_GT(walls, 40);
}

TEST(Motion, IsZeroWhereNothingMoves) {
    for (const Image& image :
         {Moving(Vec3f::Zero()).image(true), Moving(Vec3f(1, 0, 0)).image(false)}) {
        for (const Vec2f& motion : image.motion) EXPECT_EQ(motion, Vec2f(0, 0));
    }
}

}  // namespace
}  // namespace lancret
