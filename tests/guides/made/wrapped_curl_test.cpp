#include "guides/made/wrapped_curl.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>

namespace lancret {
namespace {

/// Straight strands of 10 cm up from places on the x axis.
Strands upright(int count) {
    Strands out;
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < 12; ++j) {
            out.points.emplace_back(float(i), 0.0f, 10 * float(j) / 11);
        }
        out.first.push_back(std::uint32_t(out.points.size()));
    }
    return out;
}

TEST(WrappedCurl, WindsAboutTheStrandAtItsRadius) {
    const Strands curled = wrapped_in_curls(upright(3), {0.02, 8, 0}, 1);
    ASSERT_EQ(curled.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto points = curled.strand(i);
        const std::size_t n = points.size() - 1;
        EXPECT_EQ(points[0], Vec3f(float(i), 0, 0));
        double turned = 0, before = 0;
        for (std::size_t j = 0; j <= n; ++j) {
            const double t = double(j) / double(n);
            const Vec3 off = points[j].cast<double>() - Vec3(double(i), 0, 10 * t);
            // 0.02 of 10 cm, once it has grown in; round-off of 10 cm in float.
            EXPECT_NEAR(off.norm(), 0.2 * std::min(1.0, 5 * t), 2e-6);
            EXPECT_NEAR(off.z(), 0, 2e-6);
            const double angle = std::atan2(off.y(), off.x());
            if (j > 1) turned += std::remainder(angle - before, 2 * kPi);
            before = angle;
        }
        // All 8 turns except for the first step, whose start has no angle.
        EXPECT_NEAR(std::abs(turned), 16 * kPi * (1 - 1 / double(n)), 1e-3);
    }
}

TEST(WrappedCurl, WithoutRadiusIsTheStrand) {
    const Strands curled = wrapped_in_curls(upright(1), {0, 8, 0.5}, 1);
    for (const Vec3f& p : curled.points) {
        EXPECT_EQ(p.x(), 0);
        EXPECT_EQ(p.y(), 0);
    }
    EXPECT_EQ(curled.points.back(), Vec3f(0, 0, 10));
}

TEST(WrappedCurl, PhasesAreUniformAndTurnsVaryByTheJitter) {
    constexpr int kStrands = 2000;
    const Strands curled = wrapped_in_curls(upright(kStrands), {0.02, 4, 0}, 7);
    Vec2 mean = Vec2::Zero();
    for (std::size_t i = 0; i < kStrands; ++i) {
        const Vec3f tip = curled.strand(i).back() - Vec3f(float(i), 0, 10);
        mean += Vec2(tip.x(), tip.y()) / 0.2 / kStrands;
    }
    // The mean of n uniform directions: each component has variance 1 / (2 n); five of
    // its standard deviations are exceeded once in 10^5.
    EXPECT_LT(mean.norm(), 5 / std::sqrt(2.0 * kStrands));

    // The same phases with jitter: the tips turn further by 2 pi 4 jitter normal.
    const Strands jittered = wrapped_in_curls(upright(kStrands), {0.02, 4, 0.01}, 7);
    double squares = 0;
    for (std::size_t i = 0; i < kStrands; ++i) {
        const Vec3f a = curled.strand(i).back() - Vec3f(float(i), 0, 10);
        const Vec3f b = jittered.strand(i).back() - Vec3f(float(i), 0, 10);
        const double angle =
            std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y());
        squares += angle * angle / kStrands;
    }
    // The relative error of a standard deviation of n normal numbers is 1 / sqrt(2 n).
    const double expected = 8 * kPi * 0.01;
    EXPECT_NEAR(std::sqrt(squares), expected, 5 * expected / std::sqrt(2.0 * kStrands));
}

TEST(WrappedCurl, DependsOnTheSeedButNotOnTheThreadCount) {
    const Strands all = wrapped_in_curls(upright(50), {0.02, 8, 0.1}, 3);
    EXPECT_NE(all.points, wrapped_in_curls(upright(50), {0.02, 8, 0.1}, 4).points);
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(all.points, wrapped_in_curls(upright(50), {0.02, 8, 0.1}, 3).points);
}

TEST(WrappedCurl, RejectsSettingsOutOfRange) {
    for (const CurlSettings curl : {CurlSettings{-0.1, 8, 0}, CurlSettings{0.1, 101, 0},
                                    CurlSettings{0.1, 8, std::nan("")}}) {
        EXPECT_THROW(wrapped_in_curls(upright(1), curl, 1), std::invalid_argument);
    }
}

}  // namespace
}  // namespace lancret
