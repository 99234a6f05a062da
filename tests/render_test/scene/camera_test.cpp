#include "render_test/scene/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "render_test/sampling/sampler.h"
#include "render_test/trace/render.h"
#include "tests/render_test/make_curves.h"
#include "tests/render_test/statistics.h"

namespace lancret {
namespace {

/// The projection of a point, within [-1, 1] across and up if inside the picture.
Vec2f seen(const Camera& camera, const Vec3f& point) {
    const Vec3f p = camera.frame.transpose() * (point - camera.position);
    return {p.x() / -p.z() / (camera.tangent * camera.aspect),
            p.y() / -p.z() / camera.tangent};
}

TEST(Camera, FramesEveryCornerAndTouchesOneWithoutMargin) {
    const Eigen::AlignedBox3f box(Vec3f(-3, 10, 2), Vec3f(9, 12, 30));
    for (const Vec3f& view : {Vec3f(0, 0, -1), Vec3f(1, -2, 0.5f), Vec3f(0, -1, 0)}) {
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
}

TEST(Camera, RaysOfThePicturesPlacesPassWhereThePointIsSeen) {
    const Camera camera =
        look_at(Vec3f(3, 4, 5), Vec3f(0, 1, 0), Vec3f::UnitY(), 0.9f, 1.5f);
    for (const float x : {0.0f, 0.3f, 1.0f}) {
        for (const float y : {0.0f, 0.8f, 1.0f}) {
            const Ray ray = camera.ray({x, y});
            EXPECT_NEAR(ray.direction.norm(), 1, 1e-6f);
            const Vec2f at = seen(camera, ray.origin + 7 * ray.direction);
            EXPECT_NEAR(at.x(), 2 * x - 1, 1e-5f);
            EXPECT_NEAR(at.y(), 1 - 2 * y, 1e-5f);
        }
    }
    EXPECT_GT(camera.frame.col(1).dot(Vec3f::UnitY()), 0);
    EXPECT_NEAR(camera.frame.determinant(), 1, 1e-6f);
}

TEST(Camera, OutOfFocusAPointIsADiscOfTheClosedFormSize) {
    Camera camera = look_at(Vec3f(3, 4, 5), Vec3f(0, 1, 0), Vec3f::UnitY(), 0.6f, 1.5f);
    camera.lens_radius = 0.8f;
    camera.focus_distance = 20;
    std::mt19937 random(1);
    for (const float depth : {10.0f, 20.0f, 55.0f}) {
        // At depth d a ray differs from the pinhole's by its position on the lens times 1
        // - d / f: similar triangles about the point in focus.
        const float radius = 0.8f * std::abs(1 - depth / 20);
        const Vec2f place(0.3f, 0.8f);
        const Ray chief = camera.ray(place);
        const Vec3f middle =
            chief.origin + depth / chief.direction.dot(camera.view()) * chief.direction;
        Mean squares, x;
        for (int i = 0; i < 5000; ++i) {
            const float u = unit_float(random());
            const Ray ray = camera.ray(place, {u, unit_float(random())});
            EXPECT_NEAR((ray.origin - camera.position).dot(camera.view()), 0, 1e-5f);
            const Vec3f at =
                ray.origin + depth / ray.direction.dot(camera.view()) * ray.direction;
            ASSERT_LE((at - middle).norm(), radius + 2e-5f);  // rounding of 55 cm
            squares.add((at - middle).squaredNorm());
            x.add((at - middle).dot(camera.frame.col(0)));
        }
        // Uniform over a disc: mean square radius R^2 / 2.
        EXPECT_NEAR(squares.value(), radius * radius / 2,
                    kSigmas * squares.error() + 1e-9);
        EXPECT_NEAR(x.value(), 0, kSigmas * x.error() + 2e-5);
    }
}

TEST(Camera, PictureOfAStrandOutOfFocusIsAsWideAsTheLensMakesIt) {
    // A strand 0.2 cm wide across the picture at 60 cm, focus at 30 cm, lens radius 3 cm.
    // A ray from y on the lens aimed at Y in focus is at 2 Y - y there: the strand
    // appears at Y = (y + w) / 2, of variance (3^2 / 4 + 0.2^2 / 12) / 4, plus p^2 / 12
    // for the position within a pixel.
    std::vector<Vec3f> row;
    for (int i = 0; i <= 8; ++i) row.push_back(Vec3f(float(20 * i - 80), 0, -60));
    const Curves curves = curves_through({row}, 0.1f);
    const HairScene geometry(curves);
    RenderScene scene;
    scene.geometry = &geometry;
    RenderSettings settings;
    settings.width = 4, settings.height = 200;
    settings.samples = 256;
    Camera camera = look_at(Vec3f::Zero(), Vec3f(0, 0, -1), Vec3f::UnitY(),
                            2 * std::atan(0.1f), 0.02f);
    camera.lens_radius = 3;
    camera.focus_distance = 30;
    const Image image = render(scene, camera, settings);
    const double pixel = 6.0 / 200;  // cm in focus
    double weight = 0, second = 0;
    for (int y = 0; y < 200; ++y) {
        for (int x = 0; x < 4; ++x) {
            const double alpha = image.rgba[std::size_t(4 * y + x)].w();
            const double at = (y + 0.5 - 100) * pixel;
            weight += alpha, second += alpha * at * at;
        }
    }
    const double expected = (9 / 4.0 + 0.04 / 12) / 4 + pixel * pixel / 12;
    // About a tenth of 800 x 256 / 15 hits of a variable whose square scatters by its own
    // mean: 1 / sqrt(14,000) = 0.9 %.
    EXPECT_NEAR(second / weight, expected, 4.5 * 0.009 * expected);
    EXPECT_GT(weight, 10);
}

TEST(Camera, MatrixOfACameraRestoresItAtAnyScale) {
    const Camera camera =
        look_at(Vec3f(3, 4, 5), Vec3f(0, 1, 0), Vec3f::UnitY(), 0.6f, 1.5f);
    for (const double scale : {1.0, 0.01, 30.0}) {
        Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
        matrix.topLeftCorner<3, 3>() = scale * camera.frame.cast<double>();
        matrix.topRightCorner<3, 1>() = camera.position.cast<double>();
        const Camera again = camera_of_matrix(matrix, 0.6f, 1.5f);
        EXPECT_LT((again.frame - camera.frame).norm(), 1e-6f);
        EXPECT_EQ(again.position, camera.position);
        EXPECT_EQ(again.tangent, camera.tangent);
        Eigen::Matrix4d wrong = matrix;
        wrong.col(0) *= -1;  // left-handed
        EXPECT_THROW(camera_of_matrix(wrong, 0.6f, 1), std::invalid_argument);
        wrong = matrix;
        wrong.col(0) *= 1.1;  // sheared
        EXPECT_THROW(camera_of_matrix(wrong, 0.6f, 1), std::invalid_argument);
        wrong = matrix;
        wrong(3, 0) = 1;  // projective: most likely row vectors
        EXPECT_THROW(camera_of_matrix(wrong, 0.6f, 1), std::invalid_argument);
    }
}

TEST(Camera, LensOfAStopIsThatOfItsFocalLength) {
    // 24 mm of film at 2 atan(12 / 50): a 50 mm lens; f/2 is 25 mm across.
    EXPECT_NEAR(lens_radius_of(2, 2 * std::atan(12 / 50.0f)), 1.25f, 1e-5f);
}

TEST(Camera, RefusesAnEmptySubject) {
    EXPECT_THROW(framed(Eigen::AlignedBox3f(), {}), std::invalid_argument);
    EXPECT_THROW(look_at(Vec3f::Ones(), Vec3f::Ones(), Vec3f::UnitY(), 1, 1),
                 std::invalid_argument);
    EXPECT_THROW(look_at(Vec3f::Ones(), Vec3f::Zero(), Vec3f::UnitY(), 4, 1),
                 std::invalid_argument);
}

}  // namespace
}  // namespace lancret
