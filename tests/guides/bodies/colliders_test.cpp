#include "guides/bodies/colliders.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/parallel_for.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "guides/helix/helix.h"
#include "tests/guides/bodies/box_mesh.h"
#include "tests/guides/mesh/meshes.h"

namespace lancret {
namespace {

constexpr double kFar = 1e6;

RigidPose turned(double angle, const Vec3& axis, const Vec3& move) {
    return {Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix(), move};
}

void expect_consistent(const SurfaceSample& sample, const Vec3& x, double expected) {
    // Coordinates of up to 10 cm through a pose and back: a few ulps of 10.
    EXPECT_NEAR(sample.distance, expected, 2e-14);
    EXPECT_NEAR(sample.normal.norm(), 1, 1e-14);
    EXPECT_LT((sample.point + sample.distance * sample.normal - x).norm(), 2e-14);
}

TEST(Colliders, SphereIsItsClosedForm) {
    Colliders colliders;
    const Vec3 centre(1, -2, 0.5);
    EXPECT_EQ(colliders.add(Capsule{centre, centre, 1.5}), 0);
    for (const Vec3& x : {Vec3(4, 2, 0.5), Vec3(1.1, -2, 0.5), Vec3(0, -2, 3)}) {
        const SurfaceSample sample = colliders.nearest(x, kFar);
        expect_consistent(sample, x, (x - centre).norm() - 1.5);
        EXPECT_LT((sample.normal - (x - centre).normalized()).norm(), 1e-14);
        EXPECT_EQ(sample.collider, 0);
    }
    const SurfaceSample middle = colliders.nearest(centre, kFar);
    expect_consistent(middle, centre, -1.5);
}

TEST(Colliders, CapsuleIsItsClosedForm) {
    Colliders colliders;
    const RigidPose pose = turned(0.8, {1, 2, -1}, {3, 4, 5});
    colliders.add(Capsule{{-2, 0, 0}, {2, 0, 0}, 0.5}, pose);
    const struct {
        Vec3 place;
        double distance;
    } cases[] = {
        {{0, 3, 4}, 4.5},
        {{1.7, 0, 0.2}, -0.3},
        {{5, 4, 0}, 4.5},
        {{-2, 0, -0.75}, 0.25},
        {{1, 0, 0}, -0.5},
        {{-2.3, 0, 0.4}, 0},
        {{-2 - 3, 2, 2 * 1.5}, std::sqrt(22.0) - 0.5},
    };
    for (const auto& [place, distance] : cases) {
        expect_consistent(colliders.nearest(pose * place, kFar), pose * place, distance);
    }
}

TEST(Colliders, PosedBoxIsItsClosedForm) {
    Colliders colliders;
    const Vec3 half(1, 2, 0.5);
    const RigidPose pose = turned(2.1, {1, -1, 3}, {-4, 2, 1});
    colliders.add(box_mesh(half.cast<float>()), pose);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinate(-3, 3);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 place(coordinate(random), coordinate(random), coordinate(random));
        expect_consistent(colliders.nearest(pose * place, kFar), pose * place,
                          box_distance(half, place));
    }
}

TEST(Colliders, NearestIsTheSmallestAndOfEqualOnesTheFirst) {
    Colliders colliders;
    const RigidPose there = turned(0, Vec3::UnitX(), {0.8, 0, 0});
    colliders.add(box_mesh({1, 1, 1}));
    colliders.add(Capsule{{3, 0, 0}, {3, 0, 0}, 1});
    colliders.add(box_mesh({1, 1, 1}), there);
    colliders.add(box_mesh({1, 1, 1}));
    std::mt19937 random(2);
    std::uniform_real_distribution<double> coordinate(-5, 5);
    int seen[4] = {};
    for (int i = 0; i < 3000; ++i) {
        const Vec3 x(coordinate(random), coordinate(random), coordinate(random));
        const double d[] = {box_distance(Vec3::Ones(), x), (x - Vec3(3, 0, 0)).norm() - 1,
                            box_distance(Vec3::Ones(), x - Vec3(0.8, 0, 0))};
        const double least = *std::min_element(d, d + 3);
        for (const double within : {0.5, 2.0, kFar}) {
            const SurfaceSample sample = colliders.nearest(x, within);
            if (std::abs(least - within) < 1e-13) continue;
            if (least > within) {
                EXPECT_EQ(sample.collider, -1);
                EXPECT_TRUE(std::isinf(sample.distance));
            } else {
                expect_consistent(sample, x, least);
                ++seen[sample.collider];
            }
        }
    }
    EXPECT_GT(seen[0], 100);
    EXPECT_GT(seen[1], 100);
    EXPECT_GT(seen[2], 100);
    EXPECT_EQ(seen[3], 0);  // hidden behind body 0
}

TEST(Colliders, DeepInsideIsFoundWithAnyReach) {
    Colliders colliders;
    colliders.add(box_mesh({2, 2, 2}));
    EXPECT_NEAR(colliders.nearest({0.5, 0, 0}, 0.01).distance, -1.5, 1e-15);
}

TEST(Colliders, BehindAMeshWithBordersIsInsideDownToItsDepth) {
    const RigidPose pose = turned(0.5, {1, 1, 0}, {0, 0, 0});
    const auto at = [&](const Colliders& colliders, double height, double within) {
        return colliders.nearest(pose * Vec3(0.3, 0.4, height), within);
    };
    Colliders thin, thick;
    thin.add(square_mesh(1, 2), pose, 0);
    thick.add(square_mesh(1, 2), pose, 0.5);
    EXPECT_NEAR(at(thin, -0.05, 0.1).distance, -0.05, 1e-15);
    EXPECT_EQ(at(thin, -0.2, 0.1).collider, -1);
    EXPECT_NEAR(at(thick, -0.4, 0.1).distance, -0.4, 1e-15);
    EXPECT_EQ(at(thick, -0.6, 0.1).collider, -1);
    EXPECT_EQ(at(thick, 0.4, 0.1).collider, -1);  // none in front
    // Deeper in the sheet than in a ball in front of it, in either order.
    const Vec3 centre(0.3, 0.4, -0.4);
    for (const bool ball_first : {false, true}) {
        Colliders both;
        if (ball_first) both.add(Capsule{centre, centre, 0.1}, pose);
        both.add(square_mesh(1, 2), pose, 0.5);
        if (!ball_first) both.add(Capsule{centre, centre, 0.1}, pose);
        EXPECT_NEAR(at(both, -0.4, 0.05).distance, -0.4, 1e-15);
        EXPECT_EQ(at(both, -0.4, 0.05).collider, ball_first ? 1 : 0);
    }
}

TEST(Colliders, MoveMakesTheCurrentPoseThePrevious) {
    Colliders colliders;
    const RigidPose first = turned(0.3, {0, 1, 0}, {1, 0, 0}),
                    second = turned(0.9, {1, 1, 0}, {0, 2, 0}),
                    third = turned(-0.5, {0, 0, 1}, {0, 0, -3});
    colliders.add(Capsule{{-1, 0, 0}, {1, 0, 0}, 0.5}, first);
    colliders.add(box_mesh({1, 1, 1}), first);
    const Vec3 fixed(0.2, 0.9, 1.1);
    for (int i = 0; i < 2; ++i) {
        const SurfaceSample on{0, Vec3::UnitZ(), Vec3::Zero(), i, 0};
        EXPECT_LT((colliders.carried(on, first * fixed) - first * fixed).norm(), 1e-15);
        colliders.move(i, second);
        EXPECT_LT((colliders.carried(on, first * fixed) - second * fixed).norm(), 1e-14);
        colliders.move(i, third);
        EXPECT_LT((colliders.carried(on, second * fixed) - third * fixed).norm(), 1e-14);
        colliders.move(i, third);
        EXPECT_LT((colliders.carried(on, third * fixed) - third * fixed).norm(), 1e-14);
    }
    expect_consistent(colliders.nearest(third * Vec3(0, 0, 2), kFar),
                      third * Vec3(0, 0, 2), 1);
}

TEST(Colliders, ADeformedMeshCarriesPointsThatStick) {
    Colliders colliders;
    TriangleMesh mesh = square_mesh(2, 2);
    colliders.add(mesh);
    const Vec3 x(0.6, 0.3, 0.25);
    // Sheared in its plane, then turned and moved: heights are kept, places in the plane
    // are sheared.
    Mat3 shear = Mat3::Identity();
    shear(0, 1) = 0.5;
    const RigidPose turn = turned(0.5, {1, 0, 0}, {0, 0, 1});
    std::vector<Vec3f> moved;
    for (const Vec3f& p : mesh.positions) {
        moved.push_back((turn * (shear * p.cast<double>())).cast<float>());
    }
    const SurfaceSample before = colliders.nearest(x, kFar);
    EXPECT_NEAR(before.distance, 0.25, 1e-15);
    colliders.move(0, moved);
    const Vec3 expected = turn * (shear * x);
    // The moved vertices are floats of at most 2 cm: 1.2e-7 each, twice.
    EXPECT_LT((colliders.carried(before, x) - expected).norm(), 5e-7);
    EXPECT_NEAR(colliders.nearest(expected, kFar).distance, 0.25, 5e-7);
    // Once more at the same place: at rest.
    colliders.move(0, moved);
    EXPECT_LT((colliders.carried(before, expected) - expected).norm(), 1e-14);
    // Then rigidly: the deformation is over.
    const RigidPose pose = turned(1, {1, 2, 3}, {1, 1, 1});
    colliders.move(0, pose);
    EXPECT_LT((colliders.carried(before, expected) - pose * expected).norm(), 1e-14);
}

TEST(Colliders, ACornerCarriesIfItsTriangleHasNoArea) {
    TriangleMesh mesh = square_mesh(1, 1);
    mesh.positions.push_back({0, 0, 0});
    mesh.triangles.push_back({0, 4, 3});
    mesh.uvs.clear();
    Colliders colliders;
    colliders.add(mesh);
    std::vector<Vec3f> moved = mesh.positions;
    for (Vec3f& p : moved) p += Vec3f(0, 0, 0.5f);
    colliders.move(0, moved);
    const SurfaceSample on{0, Vec3::UnitZ(), Vec3::Zero(), 0, 2};
    EXPECT_EQ(colliders.carried(on, {0.25, 0.5, 1}), Vec3(0.25, 0.5, 1.5));
}

TEST(Colliders, IsTheSameFromManyThreads) {
    Colliders colliders;
    colliders.add(sphere_mesh(24), turned(1, {1, 1, 1}, {0.1, 0, 0}));
    colliders.add(Capsule{{0, -2, 0}, {0, -1, 0}, 0.4});
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    std::vector<Vec3> places(2000), points(2000);
    for (Vec3& p : places) p = {normal(random), normal(random), normal(random)};
    tbb::parallel_for(std::size_t(0), places.size(), [&](std::size_t i) {
        points[i] = colliders.nearest(places[i], 0.5).point;
    });
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_EQ(points[i], colliders.nearest(places[i], 0.5).point);
    }
}

TEST(Colliders, RejectsInvalidBodies) {
    Colliders colliders;
    const double nan = std::nan("");
    const RigidPose bad{2 * Mat3::Identity(), Vec3::Zero()},
        mirrored{-Mat3::Identity(), Vec3::Zero()}, lost{Mat3::Identity(), {nan, 0, 0}};
    for (const RigidPose& pose : {bad, mirrored, lost}) {
        EXPECT_THROW(colliders.add(Capsule{}, pose), std::invalid_argument);
    }
    EXPECT_THROW(colliders.add(Capsule{{nan, 0, 0}, {0, 0, 0}, 1}),
                 std::invalid_argument);
    EXPECT_THROW(colliders.add(Capsule{{0, 0, 0}, {0, 0, 0}, -1}), std::invalid_argument);
    EXPECT_THROW(colliders.add(TriangleMesh{}), std::invalid_argument);
    EXPECT_THROW(colliders.add(square_mesh(1, 1), {}, nan), std::invalid_argument);
    EXPECT_EQ(colliders.size(), 0);
    EXPECT_EQ(colliders.nearest({0, 0, 0}, kFar).collider, -1);
    colliders.add(Capsule{});
    colliders.add(square_mesh(1, 1));
    const std::vector<Vec3f> three(3, Vec3f::Zero()),
        four(4, Vec3f::Constant(float(nan)));
    EXPECT_THROW(colliders.move(2, RigidPose{}), std::invalid_argument);
    EXPECT_THROW(colliders.move(-1, RigidPose{}), std::invalid_argument);
    EXPECT_THROW(colliders.move(0, three), std::invalid_argument);
    EXPECT_THROW(colliders.move(1, three), std::invalid_argument);
    EXPECT_THROW(colliders.move(1, four), std::invalid_argument);
    EXPECT_NEAR(colliders.nearest({0.5, 0.5, 3}, kFar).distance, std::sqrt(9.5) - 1,
                1e-14);
}

TEST(Colliders, NoSurfaceMovesFartherThanTheDrift) {
    Colliders bodies;
    EXPECT_EQ(bodies.drift(), 0);
    const TriangleMesh box = box_mesh({1, 2, 3});
    bodies.add(box);
    bodies.add(Capsule{Vec3(1, 0, 0), Vec3(4, 1, 0), 0.5});
    const auto turned = [](double angle, const Vec3& by) {
        return RigidPose{helix_step<double>(Vec3(0.3, 0.5, -0.2), angle).rotation, by};
    };
    // The drift is relative to the first body, which never drifts.
    bodies.move(0, turned(1, Vec3(5, 0, 0)));
    bodies.move(1, turned(1, Vec3(5, 0, 0)));
    EXPECT_LT(bodies.drift(), 1e-12);
    const RigidPose from = turned(1, Vec3(5, 0, 0)), first = turned(1.2, Vec3(5, 1, 0)),
                    second = turned(0.3, Vec3(4, 0, 2));
    bodies.move(0, first);
    bodies.move(1, second);
    const double drift = bodies.drift();
    double furthest = 0;
    for (int i = 0; i <= 20; ++i) {
        for (const Vec3& out : {Vec3(0, 0.5, 0), Vec3(0, 0, -0.5), Vec3(0, -0.3, 0.4)}) {
            const Vec3 x = Vec3(1, 0, 0) + i / 20. * Vec3(3, 1, 0) + out;
            const Vec3 before = inverse_image(from, from * x),
                       now = inverse_image(first, second * x);
            furthest = std::max(furthest, (now - before).norm());
        }
    }
    EXPECT_GE(drift, furthest);
    EXPECT_LT(drift, furthest + 2);  // not arbitrarily large: corners add this much
}

}  // namespace
}  // namespace lancret
