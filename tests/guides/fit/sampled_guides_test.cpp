#include "guides/fit/sampled_guides.h"

#include <gtest/gtest.h>

#include <cmath>

#include "guides/helix/super_helix.h"

namespace lancret {
namespace {

/// A helix of radius 1 and rise 0.5 per radian over two turns, sampled at n steps.
SampledCurve sampled_helix(int n) {
    const double h = 0.5, speed = std::sqrt(1 + h * h), turn = 4 * 3.14159265358979;
    SampledCurve out;
    out.length = speed * turn;
    for (int i = 0; i <= n; ++i) {
        const double a = turn * i / n;
        out.positions.emplace_back(std::cos(a), std::sin(a), h * a);
        out.tangents.push_back(Vec3(-std::sin(a), std::cos(a), h) / speed);
    }
    return out;
}

TEST(SampledGuides, TangentsAtJointsAreThoseOfTheStrand) {
    const SampledCurve target = sampled_helix(32);
    const FittedGuide guide = read_super_helix(target, Vec3::UnitX());
    HelixState<double> state{guide.root_frame, target.positions[0]};
    for (std::size_t i = 0; i < 32; ++i) {
        advance<double>(state, guide.curvatures[i], target.step());
        // Round-off of 32 steps.
        EXPECT_LT((state.frame.col(0) - target.tangents[i + 1]).norm(), 1e-13);
    }
}

TEST(SampledGuides, AHelixIsExact) {
    // Its torsion is h / (1 + h^2) = 0.4. After the steps of the twist a share
    // (least / (slope + least))^4 of it remains, where least^2 / slope^2 = (0.02 /
    // bend)^2 and the bend is 0.35 radian: 1e-10, over 14 cm.
    const FittedGuide guide = read_super_helix(sampled_helix(32), Vec3::UnitX());
    for (const Vec3& u : guide.curvatures) {
        EXPECT_NEAR(u.x(), 0.4, 1e-6);
        EXPECT_NEAR(std::hypot(u.y(), u.z()), 0.8, 1e-6);
    }
    EXPECT_LT(guide.report.max, 1e-6);
}

TEST(SampledGuides, ANearlyStraightStrandDoesNotTwist) {
    // A straight strand of 10 cm with a file's round-off, here an alternating 1e-6 cm.
    SampledCurve noisy;
    noisy.length = 10;
    for (int i = 0; i <= 64; ++i) {
        const double side = 1e-6 * std::sin(2.0 * i), other = 1e-6 * std::cos(3.1 * i);
        noisy.positions.emplace_back(side, other, 10.0 * i / 64);
        noisy.tangents.push_back(Vec3(10 * side, 10 * other, 1).normalized());
    }
    const double ds = noisy.step();
    for (const Vec3& u : read_super_helix(noisy, Vec3::UnitX()).curvatures) {
        // Each of four steps is at most off * slope / least^2 with off = 5e-6, slope =
        // bend ds / 12 and least = 0.02 ds / 12, for a bend of 3e-5 radian.
        EXPECT_LT(std::abs(u.x()) * ds, 4 * 5e-6 * 3e-5 * 12 / (0.02 * 0.02 * ds));
    }
}

TEST(SampledGuides, AnArcIsExact) {
    SampledCurve arc;
    arc.length = 3;
    for (int i = 0; i <= 5; ++i) {
        const double a = 3.0 * i / 5;
        arc.positions.emplace_back(std::sin(a), 1 - std::cos(a), 0);
        arc.tangents.emplace_back(std::cos(a), std::sin(a), 0);
    }
    const FittedGuide guide = read_super_helix(arc, Vec3::UnitY());
    EXPECT_LT(guide.report.max, 1e-14);
    for (const Vec3& u : guide.curvatures) EXPECT_NEAR(u.norm(), 1, 1e-13);
}

TEST(SampledGuides, StrandsWithoutALengthAreLeftOut) {
    Strands strands;
    strands.points = {Vec3f(0, 0, 0), Vec3f(0, 0, 4), Vec3f(1, 0, 0), Vec3f(1, 0, 0)};
    strands.first = {0, 2, 4};
    const std::uint32_t which[] = {0, 1};
    const FittedGuides read = sample_guides(strands, which, {}, 8);
    EXPECT_EQ(read.left_out, 1u);
    ASSERT_EQ(read.guides.size(), 1u);
    EXPECT_EQ(read.guides.segments, 8);
    EXPECT_DOUBLE_EQ(guide_length(read.guides, 0), 4);
}

}  // namespace
}  // namespace lancret
