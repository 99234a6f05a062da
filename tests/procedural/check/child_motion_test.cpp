// Guides move smoothly, in small steps, through configurations that are hard for a blend:
// a child keeps its limit if its blend has one, and does not pop.

#include "procedural/check/child_motion.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/procedural/blend/hard_cases.h"
#include "tests/procedural/made_hair.h"

namespace lancret {
namespace {

using test::add_even;
using test::frame_along;
using test::HardCase;
using test::kForward;
using test::kHardCases;

/// One child of two guides.
Binding one_child(std::vector<float> weights = {0.55f, 0.45f}) {
    Binding out;
    out.neighbours = 2;
    out.roots.positions = {Vec3f::Zero()};
    out.roots.normals = {Vec3f::UnitX()};
    out.guides = {0, 1};
    out.weights = std::move(weights);
    out.lengths = {10};
    out.guide_normals.assign(2, Vec3f::UnitX());
    return out;
}

const RigidPose kStill;

/// The largest values over all steps.
struct Steps {
    double child = 0, guides = 0, amplification = 0;
};

Steps steps_of(const HardCase& hard, Blend blend, int steps) {
    const Binding binding = one_child();
    const auto at = [&](int step) {
        Guides guides;
        hard.add(double(step) / steps, guides);
        return guide_profiles<double>(guides, 48);
    };
    Steps out;
    auto before = at(0);
    for (int i = 1; i <= steps; ++i) {
        auto now = at(i);
        const ChildMotion m = child_motion({&binding, &before, {&kStill, 1}},
                                           {&binding, &now, {&kStill, 1}}, blend, 0);
        out.child = std::max(out.child, m.child);
        out.guides = std::max(out.guides, m.guides);
        out.amplification = std::max(out.amplification, m.amplification());
        before = std::move(now);
    }
    return out;
}

/// Blends that must not pop: half the time step halves the child's largest step.
constexpr Blend kNeverPop[] = {Blend::detail, Blend::option2, Blend::option3,
                               Blend::nearest, Blend::position};

TEST(ChildMotion, NothingPopsAsGuidesPassThroughTheHardCases) {
    constexpr int kSteps = 200;
    for (const BlendTraits& entry : blends()) {
        const auto limit = amplification_limit(entry.blend);
        for (const HardCase& hard : kHardCases) {
            SCOPED_TRACE(fmt::format("{}, {}", entry.name, hard.name));
            const Steps coarse = steps_of(hard, entry.blend, kSteps),
                        fine = steps_of(hard, entry.blend, 2 * kSteps);
            fmt::print("| {} | {} | {:.4f} | {:.4f} | {:.4f} | {:.2f} | {:.2f} |\n",
                       entry.name, hard.name, fine.guides, coarse.child, fine.child,
                       coarse.child / fine.child, fine.amplification);
            EXPECT_TRUE(std::isfinite(fine.amplification));
            // The guides' steps halve, as their motion is smooth.
            EXPECT_NEAR(fine.guides / coarse.guides, 0.5, 0.01);
            if (limit) {
                // The rounding of places of 10 cm in doubles, over a motion of 5e-4 cm.
                EXPECT_LE(coarse.amplification, *limit + 1e-9);
                EXPECT_LE(fine.amplification, *limit + 1e-9);
            }
            if (std::ranges::find(kNeverPop, entry.blend) != std::end(kNeverPop)) {
                // A smooth motion's largest step halves, up to one step of 200.
                EXPECT_NEAR(fine.child / coarse.child, 0.5, 0.01);
            }
        }
    }
}

TEST(ChildMotion, AChildThatJumpsWhileItsGuidesRestIsFound) {
    Guides guides;
    add_even(guides, {0, 0, 0});
    add_even(guides, {0, 0, 0}, frame_along(Vec3::UnitY()));
    const auto profiles = guide_profiles<double>(guides, 8);
    const Binding a = one_child({1, 0}), b = one_child({0, 1});
    const MotionReport report = check_motion(
        {&a, &profiles, {&kStill, 1}}, {&b, &profiles, {&kStill, 1}}, Blend::position);
    // Its tip moves from 10 x to 10 y because it changes its only guide, and the motion
    // of its guides is measured to be the same.
    EXPECT_NEAR(report.largest_child, 10 * std::numbers::sqrt2, 1e-12);
    const Binding c = one_child({0.75, 0.25}), d = one_child({0.25, 0.75});
    const MotionReport still = check_motion(
        {&c, &profiles, {&kStill, 1}}, {&d, &profiles, {&kStill, 1}}, Blend::position);
    EXPECT_EQ(still.largest_guides, 0);
    EXPECT_NEAR(still.amplification, 5 * std::numbers::sqrt2 / kMinMotion, 1e-6);
}

TEST(ChildMotion, ARotationOfTheWholeHeadIsNoMotion) {
    const test::MadeHair hair(40, 12, 5);
    const Mat3 turn =
        Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    Binding turned = hair.binding;
    for (Vec3f& n : turned.roots.normals) n = (turn * n.cast<double>()).cast<float>();
    for (Vec3f& n : turned.guide_normals) n = (turn * n.cast<double>()).cast<float>();
    Guides guides = hair.standing.guides;
    const auto before = guide_profiles<double>(guides, 12);
    for (Mat3& f : guides.root_frames) f = turn * f;
    const auto after = guide_profiles<double>(guides, 12);
    const RigidPose pose{turn, Vec3(5, 6, 7)};
    for (const BlendTraits& entry : blends()) {
        const MotionReport report =
            check_motion({&hair.binding, &before, {&kStill, 1}},
                         {&turned, &after, {&pose, 1}}, entry.blend);
        // Float normals are accurate to 1e-7, over 16 cm; a blend may add up several such
        // errors.
        EXPECT_LT(report.largest_child, 2e-5) << entry.name;
        EXPECT_LT(report.largest_guides, 5e-6) << entry.name;
    }
    // Relative to a head at rest, everything moves.
    const MotionReport seen =
        check_motion({&hair.binding, &before, {&kStill, 1}},
                     {&turned, &after, {&kStill, 1}}, Blend::position);
    EXPECT_GT(seen.largest_child, 1);
}

TEST(ChildMotion, ManyChildrenOfPositionKeepItsLimit) {
    const test::MadeHair hair(300, 12, 5);
    Guides guides = hair.standing.guides;
    const auto before = guide_profiles<double>(guides, 12);
    std::mt19937 random(4);
    std::normal_distribution<double> normal(0, 0.1);
    for (Vec3& u : guides.curvatures) u += Vec3::Constant(normal(random));
    const auto after = guide_profiles<double>(guides, 12);
    const MotionReport report =
        check_motion({&hair.binding, &before, {&kStill, 1}},
                     {&hair.binding, &after, {&kStill, 1}}, Blend::position);
    EXPECT_GT(report.amplification, 0.1);
    EXPECT_LE(report.amplification, 1 + 1e-9);
    EXPECT_EQ(report.motion.amplification(), report.amplification);
}

}  // namespace
}  // namespace lancret
