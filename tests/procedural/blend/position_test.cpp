#include <gtest/gtest.h>

#include "procedural/blend/blend.h"
#include "tests/procedural/made_guides.h"

namespace lancret {
namespace {

TEST(PositionBlend, AChildOfOtherLengthIsItsGuideScaled) {
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
