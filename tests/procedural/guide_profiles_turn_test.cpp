// The turn of the normal where two segments of a guide meet.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "procedural/guide_profiles.h"
#include "tests/procedural/made_guides.h"

namespace lancret {
namespace {

using test::add_guide;
using test::random_guides;

constexpr double kRightAngle = std::numbers::pi / 2;

TEST(GuideProfileTurns, TheNormalNeverTurnsByMoreThanARightAngle) {
    for (unsigned seed = 0; seed < 30; ++seed) {
        const auto profiles = guide_profiles<double>(random_guides(8, 6, seed), 12);
        for (std::size_t at = 0; at < profiles.intervals.size(); ++at) {
            const ProfileInterval<double>& interval = profiles.intervals[at];
            EXPECT_LE(std::abs(interval.turn), kRightAngle + 1e-12);
            // At the root, and inside a segment, nothing turns.
            if (at % 2 == 1 || at % 12 == 0) {
                EXPECT_NEAR(interval.turn, 0, 1e-12);
            }
        }
    }
}

TEST(GuideProfileTurns, KappaTakesTheSignOfAnInflection) {
    Guides guides;
    add_guide(guides, {{0, 0, 0}, {0, 0.3, 0}, {0, 0, 0}, {0, -0.3, 0}}, 8);
    const auto profiles = guide_profiles<double>(guides, 8);
    // T' = -k1 n2: N is -n2 where it bends first, and from the root on.
    EXPECT_LT((profiles.root_normals[0] - Vec3(0, 0, -1)).norm(), 1e-12);
    for (const auto& interval : profiles.intervals) EXPECT_NEAR(interval.turn, 0, 1e-12);
    EXPECT_DOUBLE_EQ(profiles.intervals[2].kappa, 0.3);
    EXPECT_DOUBLE_EQ(profiles.intervals[6].kappa, -0.3);
}

}  // namespace
}  // namespace lancret
