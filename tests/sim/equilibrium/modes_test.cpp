#include "sim/equilibrium/modes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "sim/equilibrium/equilibrium.h"
#include "sim/equilibrium/stability.h"
#include "tests/sim/equilibrium/critical_weight.h"
#include "tests/sim/rod/made_rods.h"

namespace lancret {
namespace {

std::vector<double> frequencies(const HangingRod& rod) {
    return rod_frequencies(rod, rod_equilibrium(rod).q, 1000);
}

TEST(RodModes, OneStraightSegmentHasItsClosedForm) {
    // A straight segment of bending k moves by r = k s^2 / 2: M = L^5 / 20, K = EI L, so
    // omega^2 = 20 EI / (rho S L^4) in either plane. Twist moves nothing.
    const std::vector<double> got = frequencies(hanging_rod(1, 0));
    ASSERT_EQ(got.size(), 2u);
    for (const double omega : got) EXPECT_NEAR(omega, std::sqrt(20), 1e-13);
}

TEST(RodModes, StraightRodHasTwoPerSegmentInPairs) {
    const std::vector<double> got = frequencies(hanging_rod(9, 30));
    ASSERT_EQ(got.size(), 18u);
    for (std::size_t i = 0; i < 18; i += 2) {
        // Round-off is 1e-15 of the largest period, more relative to the shortest.
        EXPECT_NEAR(got[i] / got[i + 1], 1, 1e-6) << i;
        EXPECT_GT(got[i], i > 0 ? got[i - 1] : 0);
    }
}

TEST(RodModes, UnequalBendingSplitsThePairs) {
    // EI_2 = 4 EI_1: twice the frequency in its plane.
    const HangingRod rod =
        made_rod(6, 0, {0, 0, 0}, Vec3::UnitX(), Vec3::UnitZ(), {2. / 3, 1, 4});
    const HangingRod round = made_rod(6, 0);
    const std::vector<double> got = frequencies(rod), plain = frequencies(round);
    EXPECT_NEAR(got[0], plain[0], 1e-10);
    EXPECT_NEAR(got[1], 2 * plain[0], 1e-10);
}

TEST(RodModes, CurvedRodHasThreePerSegment) {
    EXPECT_EQ(frequencies(hanging_rod(4, 10, {1, 2, 3})).size(), 12u);
}

TEST(RodModes, NeutralDirectionHasFrequencyZero) {
    // A buckled upright rod turns about the vertical freely.
    const HangingRod rod = made_rod(6, 12, {0, 0, 0}, Vec3::UnitZ(), Vec3::UnitX());
    const std::vector<double> got = frequencies(rod);
    EXPECT_EQ(got[0], 0);
    EXPECT_GT(got[1], 1);
}

TEST(RodModes, SquareVanishesLinearlyAtTheCriticalWeight) {
    // omega^2 is smooth and 0 at buckling: at a fraction x below it, c x (1 + O(x)).
    HangingRod rod = made_rod(10, 1, {0, 0, 0}, Vec3::UnitZ(), Vec3::UnitX());
    const double critical = *critical_weight(rod, 100);
    const auto square = [&](double share) {
        rod.gravity = Vec3(0, 0, -critical * (1 - share));
        const double omega = frequencies(rod)[0];
        return omega * omega;
    };
    EXPECT_NEAR(square(1e-4) / square(1e-3), 0.1, 1e-4);
}

TEST(RodModes, UnstableShapeIsRejected) {
    const HangingRod rod = made_rod(6, 12, {0, 0, 0}, Vec3::UnitZ(), Vec3::UnitX());
    EXPECT_THROW(rod_frequencies(rod, natural_curvatures(rod), 3), std::invalid_argument);
}

TEST(RodStability, BucklingWeightsOfFewSegmentsMatchTheReference) {
    // From an independent program, to the digits given.
    const double upright[] = {7.933686, 7.861555, 7.843407};
    const double lateral[] = {13.5635, 13.0374, 12.9001};
    for (int i = 0; i < 3; ++i) {
        const int segments = 5 << i;
        EXPECT_NEAR(
            *critical_weight(
                made_rod(segments, 1, {0, 0, 0}, Vec3::UnitZ(), Vec3::UnitX()), 100),
            upright[i], 1e-6);
        const HangingRod strip = made_rod(segments, 1, {0, 0, 0}, Vec3::UnitX(),
                                          Vec3::UnitZ(), {2. / 3, 1, 1e8});
        EXPECT_NEAR(*critical_weight(strip, 100) / std::sqrt(2. / 3), lateral[i], 1e-4);
    }
}

TEST(RodStability, HangingStraightHairNeverBuckles) {
    EXPECT_FALSE(critical_weight(hanging_rod(10, 1), 1e5).has_value());
    EXPECT_FALSE(critical_weight(hanging_rod(10, 0), 1e5).has_value());
}

TEST(RodStability, FoldOfAStableBranchIsACriticalWeight) {
    // A hanging ring of three half turns, kept in its plane by its stiffness, uncoils
    // with a snap: at the fold the shape jumps.
    HangingRod rod = hanging_rod(10, 1, {0, 0, 3 * kPi});
    rod.section.stiffness = {1e3, 1e3, 1};
    const auto changes = stability_changes(rod, 200, 1);
    ASSERT_EQ(changes.size(), 1u);
    EXPECT_TRUE(changes[0].fold);
    const auto tip = [&](double share) {
        rod.gravity = Vec3(0, 0, -changes[0].weight * (1 + share));
        return tip_of(rod, rod_equilibrium(rod).q);
    };
    // At a fraction x below the fold the shape differs from that at the fold by c sqrt(x)
    // (1 + O(sqrt x)): half as much at a quarter of x. Beyond the fold it jumps.
    const Vec3 near = tip(-1e-5), apart = tip(-4e-5), farther = tip(-16e-5);
    EXPECT_NEAR((farther - apart).norm() / (apart - near).norm(), 2, 0.05);
    EXPECT_GT((tip(1e-5) - near).norm(), 20 * (apart - near).norm());
}

}  // namespace
}  // namespace lancret
