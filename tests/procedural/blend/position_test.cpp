#include <gtest/gtest.h>

#include "procedural/blend/blend.h"
#include "tests/procedural/made_guides.h"

namespace lancret {
namespace {

TEST(PositionBlend, MeetsTheMeanTipAndLosesLength) {
    Guides guides;
    test::add_guide(guides, std::vector<Vec3>(2, Vec3::Zero()), 10);
    test::add_guide(guides, std::vector<Vec3>(2, Vec3::Zero()), 10,
                    (Mat3() << 0, -1, 0, 1, 0, 0, 0, 0, 1).finished());
    const auto profiles = guide_profiles<double>(guides, 4);
    const test::MadeChild<double> made(profiles, {0.5, 0.5});
    std::vector<HelixState<double>> states(5);
    blend_position<double>(made.child(), profiles, states);
    EXPECT_LT((states[4].position - Vec3(5, 5, 0)).norm(), 1e-12);
    EXPECT_NEAR(states[4].position.norm(), 10 * std::sqrt(0.5), 1e-12);
}

TEST(PositionBlend, AChildOfAnotherLengthIsItsGuideScaled) {
    const Guides guides = test::random_guides(1, 4, 3);
    const auto profiles = guide_profiles<double>(guides, 8);
    test::MadeChild<double> made(profiles, {1.0});
    std::vector<HelixState<double>> plain(9), longer(9);
    blend_position<double>(made.child(), profiles, plain);
    made.length *= 2;
    blend_position<double>(made.child(), profiles, longer);
    for (int i = 0; i <= 8; ++i) {
        EXPECT_LT((longer[i].position - 2 * plain[i].position).norm(), 1e-12);
        EXPECT_EQ(longer[i].frame, plain[i].frame);
    }
}

}  // namespace
}  // namespace lancret
