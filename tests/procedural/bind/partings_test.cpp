#include "procedural/bind/partings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "guides/made/made_groom.h"
#include "guides/mesh/scalp.h"
#include "guides/mesh/scalp_roots.h"
#include "procedural/bind/borders.h"

namespace lancret {
namespace {

const Vec3 kUp = Vec3::UnitZ();

/// Visibility of a guide at `guide` from a child at `child`.
double sight_of(const Partings& partings, const Vec3& child, const Vec3& guide,
                const Vec3& up = kUp) {
    std::vector<SeenPiece> seen;
    std::vector<std::pair<std::uint32_t, double>> scratch;
    partings.seen_from(child, up, (guide - child).norm(), seen, scratch);
    return sight(seen_place(child, up, guide), seen);
}

TEST(Partings, HideGuidesAcrossTheStraightLine) {
    const Polyline line{{0, -1, 0}, {0, 1, 0}};
    const Partings partings({&line, 1});
    EXPECT_EQ(sight_of(partings, {-1, 0, 0}, {1, 0.3, 0}), 0);
    EXPECT_EQ(sight_of(partings, {-1, 0, 0}, {-2, 0.3, 0}), 1);
    EXPECT_EQ(sight_of(partings, {-1, 2, 0}, {1, 2, 0}), 1);
}

TEST(Partings, SightRisesLinearlyWithTheDistanceFromAnEnd) {
    // The line of 2 cm passes the end in its middle, 1 cm from either root: the width is
    // kSightSlope of that.
    const Polyline line{{0, -3, 0}, {0, 0, 0}};
    const Partings partings({&line, 1});
    for (const double share : {0.1, 0.5, 0.9, 1.0, 1.5}) {
        const double y = share * kSightSlope;
        EXPECT_NEAR(sight_of(partings, {-1, y, 0}, {1, y, 0}), std::min(share, 1.0),
                    1e-12);
    }
}

TEST(Partings, HideWhatIsBehindEitherArmOfAHorseshoe) {
    // Both arms are crossed: an even number of crossings does not make a guide visible.
    const Polyline line{{-1, -2, 0}, {-1, 1, 0}, {1, 1, 0}, {1, -2, 0}};
    const Partings partings({&line, 1});
    EXPECT_EQ(sight_of(partings, {-2, 0, 0}, {2, 0.1, 0}), 0);
    EXPECT_EQ(sight_of(partings, {-0.5, 0, 0}, {0.5, 0.2, 0}), 1);
}

TEST(Partings, OnTheFarSideOfAHeadHideNothing) {
    // Projected onto the child's plane, the parting below the head crosses the line of
    // sight.
    Polyline line;
    for (int i = -10; i <= 10; ++i) line.push_back(10 * Vec3(0, 0.05 * i, -1));
    const Partings partings({&line, 1});
    EXPECT_EQ(sight_of(partings, {-1, 0, 10}, {1, 0, 10}), 1);
}

TEST(Partings, HideWhatTheyCrossIfDrawnSlightlyAboveTheScalp) {
    const Polyline line{{0, -1, 0.2}, {0, 1, 0.3}};
    const Partings partings({&line, 1});
    // It has its full effect up to half of 0.5 cm + half the length.
    EXPECT_EQ(sight_of(partings, {-0.1, 0, 0}, {0.1, 0, 0}), 0);
}

TEST(Partings, DoNotDependOnTheirDivision) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-2, 2);
    const Polyline coarse{{-1, -1, 0}, {0.5, -0.2, 0}, {0, 1.5, 0}};
    const auto fine = divided({&coarse, 1}, 0.03);
    ASSERT_GT(fine[0].size(), 80u);
    const Partings a({&coarse, 1}), b(fine);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 child(place(random), place(random), 0);
        const Vec3 guide(place(random), place(random), 0);
        // The same maximum over more pieces, whose ends are rounded.
        EXPECT_NEAR(sight_of(a, child, guide), sight_of(b, child, guide), 1e-9);
    }
}

TEST(Partings, OfAnyLengthHaveABoundedNumberOfPieces) {
    const Polyline line{{-1e9, 0, 0}, {1e9, 0, 0}};
    const Partings partings({&line, 1});
    EXPECT_LE(partings.size(), 20001u);
    EXPECT_EQ(sight_of(partings, {3, -1, 0}, {3, 1, 0}), 0);
}

TEST(Partings, RejectPointsAndNonFiniteLines) {
    const Polyline point{{0, 0, 0}};
    const Polyline broken{{0, 0, 0}, {0, NAN, 0}};
    EXPECT_THROW(Partings({&point, 1}), std::invalid_argument);
    EXPECT_THROW(Partings({&broken, 1}), std::invalid_argument);
    EXPECT_EQ(Partings({}).size(), 0u);
    // Two coincident points are allowed and hide nothing.
    const Polyline still{{0, 0, 0}, {0, 0, 0}};
    EXPECT_EQ(sight_of(Partings({&still, 1}), {1, 1, 0}, {2, 1, 0}), 1);
}

TEST(Partings, OnTheScalpFollowItBetweenTheirPoints) {
    const MadeGroom made = make_groom({.strands = 1});
    const std::optional<Scalp> scalp = make_scalp(made.scalp);
    // A chord through the head, from front to back.
    const std::vector<Polyline> chord{{{0, 9, 5.4}, {0, 9, -5.4}}};
    double farthest = 0;
    const auto laid = partings_on_scalp(chord, scalp, farthest);
    EXPECT_GT(farthest, 1);
    for (const Vec3& p : laid[0]) {
        // The mesh is within 0.05 cm of the ellipsoid: a cell of 5 degrees sags by
        // 11 (1 - cos 2.5 degrees) = 0.01 cm along each of its sides.
        EXPECT_NEAR(p.cwiseQuotient(kMadeHead).norm(), 1, 0.05 / 7.5);
    }
}

}  // namespace
}  // namespace lancret
