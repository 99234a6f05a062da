#include "guides/made/made_lawn.h"

#include <gtest/gtest.h>

#include "guides/mesh/scalp.h"

namespace lancret {
namespace {

MadeGroomSettings lawn(int strands) {
    MadeGroomSettings settings;
    settings.kind = MadeKind::lawn;
    settings.strands = strands;
    settings.points = 12;
    settings.shortest = 5;
    settings.longest = 9;
    return settings;
}

TEST(MadeLawn, BladesHaveTheLengthsOfTheSettingsAndEqualSteps) {
    const MadeGroom made = make_lawn(lawn(300));
    ASSERT_EQ(made.strands.size(), 300u);
    for (std::size_t i = 0; i < made.strands.size(); ++i) {
        const auto first = i * 12;
        double length = 0, step = 0;
        for (std::size_t j = 1; j < 12; ++j) {
            const double ds =
                (made.strands.points[first + j] - made.strands.points[first + j - 1])
                    .norm();
            // Coordinates of up to 45 cm are rounded to 2e-6 each, two per step.
            if (j > 1) {
                EXPECT_NEAR(ds, step, 2e-5) << i;
            }
            step = ds, length += ds;
        }
        EXPECT_GE(length, 5 - 1e-4);
        EXPECT_LE(length, 9 + 1e-4);
    }
}

TEST(MadeLawn, BladesStandUpFromTheGroundAndStayAboveIt) {
    const MadeGroom made = make_lawn(lawn(500));
    EXPECT_TRUE(made.parting.empty());
    EXPECT_EQ(made.head.triangles, made.scalp.triangles);
    for (std::size_t i = 0; i < made.strands.size(); ++i) {
        const Vec3f root = made.strands.points[i * 12],
                    next = made.strands.points[i * 12 + 1];
        // The lean is at most 0.38 radian and a bow of 1.55 (0.5 / 11)^1.5, and the
        // ground no steeper than 0.55.
        EXPECT_GT((next - root).normalized().y(), std::cos(0.4 + 0.55)) << i;
        // Bent by at most 1.93 radian, a tip comes down, but not to its root.
        EXPECT_GT(made.strands.points[i * 12 + 11].y(), root.y() - 2) << i;
    }
}

TEST(MadeLawn, AStrandDoesNotDependOnTheCount) {
    const MadeGroom few = make_lawn(lawn(50)), many = make_lawn(lawn(400));
    for (std::size_t i = 0; i < few.strands.points.size(); ++i) {
        EXPECT_EQ(few.strands.points[i], many.strands.points[i]);
    }
    EXPECT_THROW(make_lawn(lawn(0)), std::invalid_argument);
}

}  // namespace
}  // namespace lancret
