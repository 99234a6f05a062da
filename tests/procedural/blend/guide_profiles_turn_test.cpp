// The normal of a guide's profile at the joints of its segments.

#include <gtest/gtest.h>

#include "procedural/blend/guide_profiles.h"
#include "tests/procedural/made_guides.h"

namespace lancret {
namespace {

using test::add_guide;
using test::random_guides;

TEST(GuideProfileTurns, TheNormalIsContinuousInsideASegment) {
    for (unsigned seed = 0; seed < 30; ++seed) {
        const auto profiles = guide_profiles<double>(random_guides(8, 6, seed), 12);
        for (std::size_t i = 1; i < profiles.intervals.size(); i += 2) {
            const auto &before = profiles.intervals[i - 1],
                       &after = profiles.intervals[i];
            EXPECT_LT((after.normal_before - before.normal_after).norm(), 1e-12);
        }
    }
}

TEST(GuideProfileTurns, NormalsAreUnitAndAcrossTheTangent) {
    const auto profiles = guide_profiles<double>(random_guides(8, 6, 1), 12);
    for (int g = 0; g < 8; ++g) {
        for (int i = 0; i < 12; ++i) {
            const auto& interval = profiles.intervals[g * 12 + i];
            EXPECT_NEAR(interval.normal.dot(interval.tangent), 0, 1e-12);
            EXPECT_NEAR(interval.normal_before.dot(profiles.tangent(g, i)), 0, 1e-12);
            EXPECT_NEAR(interval.normal_after.dot(profiles.tangent(g, i + 1)), 0, 1e-12);
            EXPECT_NEAR(interval.normal_after.norm(), 1, 1e-12);
        }
    }
}

TEST(GuideProfileTurns, StraightSegmentsCarryTheNormalAndInflectionsTurnIt) {
    Guides guides;
    add_guide(guides, {{0, 0, 0}, {0, 0.3, 0}, {0, 0, 0}, {0, -0.3, 0}}, 8);
    const auto profiles = guide_profiles<double>(guides, 8);
    const auto& row = profiles.intervals;
    // T' = -k1 n2: N is -n2 on the first bend, and from the root on.
    EXPECT_LT((row[0].normal_before - Vec3(0, 0, -1)).norm(), 1e-12);
    // N is constant over the straight third segment and reversed at its end.
    EXPECT_LT((row[5].normal_after - row[3].normal_after).norm(), 1e-12);
    EXPECT_LT((row[6].normal_before + row[5].normal_after).norm(), 1e-12);
    EXPECT_DOUBLE_EQ(row[2].kappa, 0.3);
    EXPECT_DOUBLE_EQ(row[6].kappa, 0.3);
}

}  // namespace
}  // namespace lancret
