#include "procedural/blend/motion_limit.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <memory>

#include "tests/procedural/blend/hard_cases.h"

namespace lancret {
namespace {

using test::MadeChild;

constexpr int kMotionIntervals = 48;

/// A child and its guides at one time.
struct Made {
    GuideProfiles<double> profiles;
    MadeChild<double> child;
    std::vector<HelixState<double>> states{kMotionIntervals + 1};

    Made(const Guides& guides, const std::vector<double>& weights)
        : profiles(guide_profiles<double>(guides, kMotionIntervals)),
          child(profiles, weights) {
        blend_detail<double>(child.child(), profiles, states);
    }
};

/// The largest motion of a place of the child, and its limit, cm.
struct Motion {
    double child = 0, limit = 0;
};

Motion motion(const Made& a, const Made& b) {
    Motion out;
    for (int i = 0; i <= kMotionIntervals; ++i) {
        out.child =
            std::max(out.child, (a.states[i].position - b.states[i].position).norm());
    }
    const Child<double> from = a.child.child(), to = b.child.child();
    out.limit = anchored_motion_limit({from, to, a.profiles, b.profiles});
    return out;
}

TEST(AnchorMotion, StaysWithinTheLimitOfItsGuides) {
    double worst = 0;
    const char* name = "";
    for (const test::HardCase& hard : test::kHardCases) {
        for (const double weight : {0.55, 0.9}) {
            constexpr int kSteps = 400;
            std::unique_ptr<Made> before;
            for (int i = 0; i <= kSteps; ++i) {
                Guides guides;
                hard.add(double(i) / kSteps, guides);
                auto now =
                    std::make_unique<Made>(guides, std::vector{weight, 1 - weight});
                if (before) {
                    const Motion moved = motion(*before, *now);
                    ASSERT_LE(moved.child, moved.limit) << hard.name;
                    if (moved.child > worst * moved.limit) {
                        worst = moved.child / moved.limit;
                        name = hard.name;
                    }
                }
                before = std::move(now);
            }
        }
    }
    // The limit must not be far too large.
    EXPECT_GT(worst, 0.05);
    fmt::print("largest share of the limit: {:.3f}, {}\n", worst, name);
}

TEST(AnchorMotion, StaysWithinTheLimitForRandomMotion) {
    double worst = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        const Guides from = test::random_guides(3, 6, seed, 0.5);
        Guides to = from;
        const Guides other = test::random_guides(3, 6, seed + 1000, 0.5);
        const double share = 1e-3 * (1 + seed % 5);
        for (std::size_t q = 0; q < to.curvatures.size(); ++q) {
            to.curvatures[q] += share * (other.curvatures[q] - from.curvatures[q]);
        }
        for (std::size_t g = 0; g < 3; ++g) {
            const Vec3 turn = share * other.root_frames[g].col(0);
            to.root_frames[g] = helix_step<double>(turn, 1).rotation * to.root_frames[g];
        }
        const std::vector<double> weights{0.5, 0.3, 0.2};
        const Motion moved = motion(Made(from, weights), Made(to, weights));
        ASSERT_LE(moved.child, moved.limit) << seed;
        worst = std::max(worst, moved.child / moved.limit);
    }
    EXPECT_GT(worst, 0.05);
    fmt::print("largest share of the limit: {:.3f}\n", worst);
}

}  // namespace
}  // namespace lancret
