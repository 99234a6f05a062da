#include "procedural/blend/guide_profiles.h"

#include <gtest/gtest.h>

#include <cmath>

#include "guides/helix/super_helix.h"
#include "procedural/blend/blend.h"
#include "tests/procedural/made_guides.h"

namespace lancret {
namespace {

using test::add_guide;
using test::random_guides;

TEST(GuideProfiles, PlacesAndTangentsAreThoseOfTheGuide) {
    const Guides guides = random_guides(10, 5, 1);
    // A grid that contains the guides' joints, and one that does not.
    for (const int count : {20, 13}) {
        const auto profiles = guide_profiles<double>(guides, count);
        for (std::size_t g = 0; g < 10; ++g) {
            const double length = guide_length(guides, g);
            EXPECT_EQ(profiles.lengths[g], length);
            EXPECT_EQ(profiles.root_frames[g], guides.root_frames[g]);
            for (int i = 0; i <= count; ++i) {
                const HelixState<double> exact =
                    state_at(super_helix(guides, g), length * i / count);
                const std::size_t place = g * (count + 1) + i;
                const Mat3& frame = guides.root_frames[g];
                EXPECT_LT((frame * profiles.positions[place] + guides.root_positions[g] -
                           exact.position)
                              .norm(),
                          1e-12 * length);
                EXPECT_LT((frame * profiles.tangent(g, i) - exact.frame.col(0)).norm(),
                          1e-12);
            }
        }
    }
}

TEST(GuideProfiles, TangentAndNormalAreOrthonormal) {
    for (unsigned seed = 0; seed < 30; ++seed) {
        const auto profiles = guide_profiles<double>(random_guides(8, 6, seed), 12);
        for (const ProfileInterval<double>& interval : profiles.intervals) {
            EXPECT_NEAR(interval.tangent.norm(), 1, 1e-12);
            EXPECT_NEAR(interval.normal.norm(), 1, 1e-12);
            EXPECT_NEAR(interval.tangent.dot(interval.normal), 0, 1e-12);
        }
    }
}

TEST(GuideProfiles, KappaAndTauAreThoseOfTheSegment) {
    const Guides guides = random_guides(6, 4, 3);
    const auto profiles = guide_profiles<double>(guides, 12);
    for (std::size_t i = 0; i < profiles.intervals.size(); ++i) {
        const Vec3& u = guides.curvatures[i / 3];
        // Copied from the segment, without a quotient.
        EXPECT_EQ(std::abs(profiles.intervals[i].kappa), std::hypot(u.y(), u.z()));
        EXPECT_EQ(profiles.intervals[i].tau, u.x());
    }
}

TEST(GuideProfiles, TheNormalPointsWhereTheStrandBends) {
    // T' = k2 n1 - k1 n2 = kappa N, by a difference of tangents over a small step.
    const Guides guides = random_guides(6, 4, 4);
    const auto profiles = guide_profiles<double>(guides, 8);
    for (std::size_t g = 0; g < 6; ++g) {
        const double length = guide_length(guides, g), h = 1e-5 * length;
        for (int i = 0; i < 8; ++i) {
            const double s = length * (i + 0.5) / 8;
            const SuperHelix helix = super_helix(guides, g);
            const Vec3 bend = guides.root_frames[g].transpose() *
                              (state_at(helix, s + h).frame.col(0) -
                               state_at(helix, s - h).frame.col(0)) /
                              (2 * h);
            const auto& interval = profiles.intervals[g * 8 + i];
            // The difference has an error of |u|^3 h^2 / 6, and round-off of 1e-16 / h.
            EXPECT_LT((interval.kappa * interval.normal - bend).norm(), 1e-7);
        }
    }
}

TEST(GuideProfiles, TheNormalIsCarriedOverStraightParts) {
    Guides guides;
    add_guide(guides, {{0, 0, 0}, {0, 0.3, 0}, {0, 0, 0}, {0, -0.3, 0}}, 8);
    const auto profiles = guide_profiles<double>(guides, 8);
    // T' = -k1 n2: N is along n2 from the root on, in the strand's plane.
    for (const auto& interval : profiles.intervals) {
        EXPECT_NEAR(interval.normal.y(), 0, 1e-12);
        EXPECT_NEAR(interval.normal.norm(), 1, 1e-12);
    }
    // It stays on one side from the root to the inflection.
    for (int i = 1; i < 4; ++i) {
        EXPECT_GT(profiles.intervals[i].normal.dot(profiles.intervals[0].normal), 0);
    }
    EXPECT_EQ(profiles.intervals[0].kappa, 0);
    EXPECT_DOUBLE_EQ(std::abs(profiles.intervals[2].kappa), 0.3);
    EXPECT_DOUBLE_EQ(std::abs(profiles.intervals[6].kappa), 0.3);
}

/// Distance between the tip of guide 0 and that of option 1's strand from it, cm.
double tip_error(const Guides& guides, int count) {
    const auto profiles = guide_profiles<double>(guides, count);
    const test::MadeChild<double> made(profiles, {1.0});
    std::vector<HelixState<double>> states(count + 1);
    blend_option1<double>(made.child(), profiles, states);
    const HelixState<double> tip =
        state_at(super_helix(guides, 0), guide_length(guides, 0));
    return (states[count].position + guides.root_positions[0] - tip.position).norm();
}

TEST(GuideProfiles, JointsOffTheGridCostTheSquareOfTheStep) {
    for (unsigned seed = 0; seed < 10; ++seed) {
        const Guides guides = random_guides(1, 5, seed, 0.3);
        for (const int count : {32, 64, 128, 512}) {
            const double ds = guide_length(guides, 0) / count;
            // A jump of d in curvature, spread over an interval, changes the tangent by
            // at most d ds / 4, at the joint, and the place by d ds^2 / 8; the frame
            // after it is exact. The rest is of the next order in |u| ds < 0.5.
            double bound = 1e-9;
            for (int q = 0; q < 4; ++q) {
                bound += 1.5 * (guides.curvatures[q + 1] - guides.curvatures[q]).norm() *
                         ds * ds / 8;
            }
            EXPECT_LT(tip_error(guides, count), bound) << seed << " at " << count;
        }
        EXPECT_LT(tip_error(guides, 50), 1e-9);  // on the grid
    }
}

TEST(GuideProfiles, OfUnequalSegmentsGiveThatGuide) {
    Guides guides;
    guides.segments = 3;
    guides.root_positions = {Vec3::Zero()};
    guides.root_frames = {Mat3::Identity()};
    guides.segment_lengths = {1, 2, 5};
    guides.curvatures = {{0.1, 0.4, 0}, {-0.2, 0, 0.5}, {0, 0.3, 0.3}};
    EXPECT_LT(tip_error(guides, 8), 1e-9);
    EXPECT_LT(tip_error(guides, 16), 1e-9);
}

}  // namespace
}  // namespace lancret
