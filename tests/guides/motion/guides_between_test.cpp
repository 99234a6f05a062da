#include "guides/motion/guides_between.h"

#include <gtest/gtest.h>

#include <random>

#include "guides/helix/super_helix.h"
#include "tests/procedural/made_guides.h"

namespace lancret {
namespace {

constexpr InTime kWays[] = {InTime::frames, InTime::curvatures};

/// `guides` with random changes of this size to curvatures and roots.
Guides shaken(Guides guides, unsigned seed, double size) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0, size);
    const auto draw = [&] {
        const double x = normal(random), y = normal(random), z = normal(random);
        return Vec3(x, y, z);
    };
    for (Vec3& u : guides.curvatures) u += draw();
    for (Vec3& p : guides.root_positions) p += draw();
    for (Mat3& f : guides.root_frames) f = helix_step<double>(draw(), 1.0).rotation * f;
    return guides;
}

Mat3 about_z(double angle) {
    return Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
}

TEST(GuidesBetween, TheEndsHaveTheBitsOfTheFrames) {
    const Guides a = test::random_guides(5, 4, 1), b = shaken(a, 2, 0.1),
                 c = shaken(b, 3, 0.1);
    for (const InTime way : kWays) {
        const GuideKeys keys{&a, &b, nullptr, &c};
        const Guides at_a = guides_between(keys, 0, way),
                     at_b = guides_between(keys, 1, way);
        EXPECT_EQ(at_a.curvatures, a.curvatures);
        EXPECT_EQ(at_a.root_frames, a.root_frames);
        EXPECT_EQ(at_b.curvatures, b.curvatures);
        EXPECT_EQ(at_b.root_frames, b.root_frames);
        EXPECT_EQ(at_b.root_positions, b.root_positions);
    }
}

TEST(GuidesBetween, CurvaturesAreLinearAndRootsTurnAtAConstantRate) {
    Guides a, b;
    test::add_guide(a, {{0.1, 0.2, 0.3}}, 5, Mat3::Identity(), {1, 2, 3});
    test::add_guide(b, {{0.5, -0.2, 0.3}}, 5, about_z(1.2), {3, 2, 1});
    const Guides at = guides_between({&a, &b}, 0.25, InTime::curvatures);
    // A quarter of each difference; doubles near 1 round by 2^-53 a few times.
    EXPECT_LT((at.curvatures[0] - Vec3(0.2, 0.1, 0.3)).norm(), 1e-15);
    EXPECT_LT((at.root_positions[0] - Vec3(1.5, 2, 2.5)).norm(), 1e-15);
    EXPECT_LT((at.root_frames[0] - about_z(0.3)).norm(), 1e-15);
}

TEST(GuidesBetween, TurnsTheShortWay) {
    Guides a, b;
    test::add_guide(a, {Vec3::Zero()}, 5, about_z(-0.1 * kPi));
    test::add_guide(b, {Vec3::Zero()}, 5, about_z(1.1 * kPi));
    for (const InTime way : kWays) {
        const Guides at = guides_between({&a, &b}, 0.5, way);
        // From -18 to 198 degrees by way of -90: 144 degrees, not 216.
        EXPECT_LT((at.root_frames[0] - about_z(-0.5 * kPi)).norm(), 1e-14);
    }
}

TEST(GuidesBetween, IsContinuousAtTheFrames) {
    // Turns of up to 2.5 / cm times 3 cm: more than one circle in a segment.
    const Guides a = test::random_guides(40, 4, 5, 1.0), b = shaken(a, 6, 0.2),
                 before = shaken(a, 7, 0.2), after = shaken(b, 8, 0.2);
    for (const InTime way : kWays) {
        const GuideKeys keys{&a, &b, &before, &after};
        for (const double share : {1e-7, 1 - 1e-7}) {
            const Guides at = guides_between(keys, share, way),
                         &end = share < 0.5 ? a : b;
            for (std::size_t i = 0; i < at.curvatures.size(); ++i) {
                // A rate of at most about 10 / cm per frame over 1e-7 frames.
                EXPECT_LT((at.curvatures[i] - end.curvatures[i]).norm(), 1e-5) << i;
            }
        }
    }
}

TEST(GuidesBetween, AConstantTurnStaysConstant) {
    // Arcs in a plane whose curvature grows linearly: every joint turns about z at a
    // constant rate, so that cubic and line agree and the curvature is that of the time.
    const auto arc = [](double k) {
        Guides out;
        test::add_guide(out, std::vector<Vec3>(6, Vec3(0, 0, k)), 12);
        return out;
    };
    const Guides w = arc(0.05), a = arc(0.1), b = arc(0.15), c = arc(0.2);
    const Guides at = guides_between({&a, &b, &w, &c}, 0.3);
    for (const Vec3& u : at.curvatures) {
        EXPECT_LT((u - Vec3(0, 0, 0.115)).norm(), 1e-14);
    }
}

TEST(GuidesBetween, ATwistThatBuildsUpBeyondHalfACircleIsKept) {
    // 6 segments that each twist by 1 radian more: the last joint has turned by 6, and
    // half way by 3, although the other way round is shorter.
    Guides a, b;
    test::add_guide(a, std::vector<Vec3>(6, Vec3::Zero()), 6);
    test::add_guide(b, std::vector<Vec3>(6, Vec3(1, 0, 0)), 6);
    const Guides at = guides_between({&a, &b}, 0.5);
    for (const Vec3& u : at.curvatures) {
        EXPECT_LT((u - Vec3(0.5, 0, 0)).norm(), 1e-13);
    }
}

TEST(GuidesBetween, HairAtRestOnATurningHeadTurnsWithIt) {
    // The guides of a head that turns by 1 radian per frame: carried, they are the rest
    // pose turned about the pivot by the angle of that time, not moved along a chord.
    const Guides rest = test::random_guides(6, 3, 11);
    const auto pose = [](double frame) {
        const Mat3 turn = about_z(frame);
        const Vec3 pivot(4, -3, 2);
        return RigidPose{turn, pivot - turn * pivot};
    };
    const auto posed = [&](double frame) {
        Guides out = rest;
        for (Mat3& f : out.root_frames) f = pose(frame).rotation * f;
        for (Vec3& p : out.root_positions) p = pose(frame) * p;
        return out;
    };
    const auto carriers = [&](double frame) {
        return std::vector<RigidPose>(rest.size(), pose(frame));
    };
    const Guides a = posed(1), b = posed(2), expected = posed(1.3);
    const RootCarriers roots{carriers(1), carriers(2), {}, {}, carriers(1.3)};
    for (const InTime way : kWays) {
        const Guides at = guides_between({&a, &b}, 0.3, way, &roots);
        for (std::size_t g = 0; g < rest.size(); ++g) {
            // Round-off of about 10 cm, a few times.
            EXPECT_LT((at.root_positions[g] - expected.root_positions[g]).norm(), 1e-13);
            EXPECT_LT((at.root_frames[g] - expected.root_frames[g]).norm(), 1e-13);
            EXPECT_LT((state_at(super_helix(at, g), 5).position -
                       state_at(super_helix(expected, g), 5).position)
                          .norm(),
                      1e-12);
        }
    }
}

TEST(GuidesBetween, RejectsMismatchedArguments) {
    const Guides a = test::random_guides(5, 4, 1), fewer = test::random_guides(4, 4, 1),
                 longer = test::random_guides(5, 4, 2);
    EXPECT_THROW(guides_between({&a, &a}, -0.1), std::invalid_argument);
    EXPECT_THROW(guides_between({&a, &a}, std::nan("")), std::invalid_argument);
    EXPECT_THROW(guides_between({&a, &fewer}, 0.5), std::invalid_argument);
    EXPECT_THROW(guides_between({&a, &longer}, 0.5), std::invalid_argument);
    const RootCarriers none;
    EXPECT_THROW(guides_between({&a, &a}, 0.5, InTime::frames, &none),
                 std::invalid_argument);
}

}  // namespace
}  // namespace lancret
