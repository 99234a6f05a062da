#include "render_test/camera.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lancret {
namespace {

/// Where a point is seen, within [-1, 1] across and up if in the picture.
Vec2f seen(const Camera& camera, const Vec3f& point) {
    const Vec3f p = camera.frame.transpose() * (point - camera.position);
    return {p.x() / -p.z() / (camera.tangent * camera.aspect),
            p.y() / -p.z() / camera.tangent};
}

TEST(Camera, FramesEveryCornerAndTouchesOneWithoutMargin) {
    const Eigen::AlignedBox3f box(Vec3f(-3, 10, 2), Vec3f(9, 12, 30));
    for (const Vec3f& view : {Vec3f(0, 0, -1), Vec3f(1, -2, 0.5f), Vec3f(0, -1, 0)})
        for (const float aspect : {0.5f, 1.0f, 2.0f}) {
            const Camera camera = framed(box, {view, Vec3f::UnitY(), 0.7f, aspect, 1.0f});
            float farthest = 0;
            for (int i = 0; i < 8; ++i) {
                const Vec3f corner = box.corner(Eigen::AlignedBox3f::CornerType(i));
                EXPECT_GT((corner - camera.position).dot(camera.view()), 0);
                farthest = std::max(farthest, seen(camera, corner).cwiseAbs().maxCoeff());
            }
            EXPECT_NEAR(farthest, 1, 1e-5f);
        }
}

TEST(Camera, RaysOfThePicturesPlacesPassWhereThePointIsSeen) {
    const Camera camera =
        look_at(Vec3f(3, 4, 5), Vec3f(0, 1, 0), Vec3f::UnitY(), 0.9f, 1.5f);
    for (const float x : {0.0f, 0.3f, 1.0f})
        for (const float y : {0.0f, 0.8f, 1.0f}) {
            const Ray ray = camera.ray({x, y});
            EXPECT_NEAR(ray.direction.norm(), 1, 1e-6f);
            const Vec2f at = seen(camera, ray.origin + 7 * ray.direction);
            EXPECT_NEAR(at.x(), 2 * x - 1, 1e-5f);
            EXPECT_NEAR(at.y(), 1 - 2 * y, 1e-5f);
        }
    EXPECT_GT(camera.frame.col(1).dot(Vec3f::UnitY()), 0);
    EXPECT_NEAR(camera.frame.determinant(), 1, 1e-6f);
}

TEST(Camera, RefusesNothingToSee) {
    EXPECT_THROW(framed(Eigen::AlignedBox3f(), {}), std::invalid_argument);
    EXPECT_THROW(look_at(Vec3f::Ones(), Vec3f::Ones(), Vec3f::UnitY(), 1, 1),
                 std::invalid_argument);
    EXPECT_THROW(look_at(Vec3f::Ones(), Vec3f::Zero(), Vec3f::UnitY(), 4, 1),
                 std::invalid_argument);
}

}  // namespace
}  // namespace lancret
