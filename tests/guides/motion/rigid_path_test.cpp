#include "guides/motion/rigid_path.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "guides/helix/helix.h"
#include "tests/guides/base/finite_difference.h"

namespace lancret {
namespace {

constexpr double kFps = 24;

RigidPath nod() {
    return make_rigid_path({{-3, {0, 0, 0}, {0, 0, 0}},
                            {5, {2, -1, 4}, {20, 50, -10}},
                            {11, {3, -4, 5}, {35, 200, -60}},
                            {20, {3, 2, -1}, {-15, 20, 30}}},
                           {1, 150, -2}, kFps);
}

TEST(RigidPath, PassesThroughItsKeys) {
    const RigidMotion at = rigid_motion(nod(), 5);
    const Vec3 theta = Vec3(20, 50, -10) * (kPi / 180);
    const Mat3 turn = Eigen::AngleAxisd(theta.norm(), theta.normalized()).matrix();
    EXPECT_LT((at.pose.rotation - turn).norm(), 1e-15);
    const Vec3 pivot(1, 150, -2), x(7, 160, 3);
    EXPECT_LT((at.pose * x - (pivot + Vec3(2, -1, 4) + turn * (x - pivot))).norm(),
              1e-12);
    EXPECT_LT((inverse_image(at.pose, at.pose * x) - x).norm(), 1e-12);
}

TEST(RigidPath, RatesMatchFiniteDifferences) {
    const RigidPath path = nod();
    for (const double frame : {-2.5, 0.1, 4.9, 5.1, 8.0, 12.3, 19.8}) {
        const RigidMotion at = rigid_motion(path, frame);
        // Rates are near 0.4 rad or 1 cm per frame, so at h = 0.02 frame truncation is
        // below 1e-11 and round-off near 1e-13 of the position per frame; times 24 per
        // second, and again 24, for sizes near 100 cm: 1e-8.
        const double h = 0.02;
        const auto derivative = [&](auto&& of) {
            return (kFps * finite_difference(of, frame, h)).eval();
        };
        const Vec3 velocity =
            derivative([&](double f) { return rigid_motion(path, f).pivot; });
        EXPECT_LT((velocity - at.velocity).norm(), 1e-8);
        const Vec3 acceleration =
            derivative([&](double f) { return rigid_motion(path, f).velocity; });
        EXPECT_LT((acceleration - at.acceleration).norm(), 1e-8);
        // R' = hat(w) R.
        const Mat3 turning =
            derivative([&](double f) { return rigid_motion(path, f).pose.rotation; });
        EXPECT_LT((turning - hat<double>(at.angular_velocity) * at.pose.rotation).norm(),
                  1e-8);
        const Vec3 angular =
            derivative([&](double f) { return rigid_motion(path, f).angular_velocity; });
        EXPECT_LT((angular - at.angular_acceleration).norm(), 1e-8);
        EXPECT_GT(at.angular_acceleration.norm(), 1e-3);
    }
}

TEST(RigidPath, IsContinuouslyDifferentiableAtKeysAndEnds) {
    const RigidPath path = nod();
    for (const double key : {-3.0, 5.0, 11.0, 20.0}) {
        const RigidMotion before = rigid_motion(path, key - 1e-9),
                          after = rigid_motion(path, key + 1e-9);
        // Accelerations are below 1e4 cm/s^2 and rad/s^2; 2e-9 frames are 1e-10 s.
        EXPECT_LT((before.velocity - after.velocity).norm(), 2e-6);
        EXPECT_LT((before.angular_velocity - after.angular_velocity).norm(), 2e-6);
        EXPECT_LT((before.pose.rotation - after.pose.rotation).norm(), 1e-7);
    }
}

TEST(RigidPath, IsConstantBeforeAndAfterItsKeys) {
    const RigidPath path = nod();
    for (const double frame : {-1e6, -3.5, 20.5, 1e6}) {
        const RigidMotion at = rigid_motion(path, frame);
        const RigidMotion end = rigid_motion(path, frame < 0 ? -3 : 20);
        EXPECT_LT((at.pose.rotation - end.pose.rotation).norm(), 1e-14);
        EXPECT_EQ(at.velocity, Vec3::Zero());
        EXPECT_EQ(at.acceleration, Vec3::Zero());
        EXPECT_EQ(at.angular_velocity, Vec3::Zero());
        EXPECT_EQ(at.angular_acceleration, Vec3::Zero());
    }
}

TEST(RigidPath, OneKeyStandsStill) {
    const RigidPath path =
        make_rigid_path({{4, {1, 2, 3}, {0, 90, 0}}}, Vec3::Zero(), 24);
    for (const double frame : {3.0, 4.0, 5.0}) {
        const RigidMotion at = rigid_motion(path, frame);
        EXPECT_LT((at.pose * Vec3(1, 0, 0) - Vec3(1, 2, 2)).norm(), 1e-15);
        EXPECT_EQ(at.angular_velocity, Vec3::Zero());
    }
}

TEST(RigidPath, RejectsInvalidPaths) {
    const double nan = std::nan("");
    const Vec3 zero = Vec3::Zero();
    EXPECT_THROW(make_rigid_path({}, zero, 24), std::invalid_argument);
    EXPECT_THROW(make_rigid_path({{0}, {0}}, zero, 24), std::invalid_argument);
    EXPECT_THROW(make_rigid_path({{1}, {0}}, zero, 24), std::invalid_argument);
    EXPECT_THROW(make_rigid_path({{nan}}, zero, 24), std::invalid_argument);
    EXPECT_THROW(make_rigid_path({{0, {0, nan, 0}}}, zero, 24), std::invalid_argument);
    EXPECT_THROW(make_rigid_path({{0, zero, {0, 0, 1e300}}}, zero, 24),
                 std::invalid_argument);
    EXPECT_THROW(make_rigid_path({{0}}, {0, nan, 0}, 24), std::invalid_argument);
    EXPECT_THROW(make_rigid_path({{0}}, zero, 0), std::invalid_argument);
    EXPECT_THROW(rigid_motion(make_rigid_path({{0}}, zero, 24), nan),
                 std::invalid_argument);
}

}  // namespace
}  // namespace lancret
