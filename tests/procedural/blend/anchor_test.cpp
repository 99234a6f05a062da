#include "procedural/blend/anchor.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/procedural/made_guides.h"

namespace lancret {
namespace {

using test::MadeChild;

constexpr int kCount = 240;
constexpr double kLength = 20;

/// A helix of `turns` whole turns about `axis`, its pitch angle off it, at `phase`.
void add_curl(Guides& guides, const Vec3& axis, double turns, double pitch,
              double phase) {
    const double omega = 2 * std::numbers::pi * turns / kLength;
    const Vec3 u(omega * std::cos(pitch), 0, omega * std::sin(pitch));
    // The root frame that has the Darboux vector along the axis, rolled to the phase.
    const Mat3 frame = Eigen::AngleAxisd(phase, axis.normalized()) *
                       Eigen::Quaterniond::FromTwoVectors(u, axis).toRotationMatrix();
    test::add_guide(guides, std::vector<Vec3>(12, u), kLength, frame);
}

struct Shape {
    Vec3 chord;
    double kappa;  ///< mean, 1/cm
};

Shape shape_of(BlendFunction<double> blend, const Guides& guides,
               const std::vector<double>& weights) {
    const auto profiles = guide_profiles<double>(guides, kCount);
    const MadeChild<double> made(profiles, weights);
    std::vector<HelixState<double>> states(kCount + 1);
    blend(made.child(), profiles, states);
    Shape out{states[kCount].position, 0};
    for (int i = 0; i < kCount; ++i) {
        const Mat3 turn = states[i].frame.transpose() * states[i + 1].frame;
        const Vec3 u = rotation_log<double>(turn) * (kCount / made.length);
        out.kappa += std::hypot(u.y(), u.z()) / kCount;
    }
    return out;
}

TEST(Detail, KeepsThePlaceAndTheCurlOfCurlsOfUnlikePhase) {
    // Two curls of opposite phase about axes 0.4 radian apart. Places cancel to straight
    // strands; detail has the curvature of one and ends where they do.
    const double pitch = 0.8, turns = 10;
    Guides guides;
    add_curl(guides, Vec3(1, 0.2, 0), turns, pitch, 0);
    add_curl(guides, Vec3(1, -0.2, 0), turns, pitch, std::numbers::pi);
    const double kappa = 2 * std::numbers::pi * turns / kLength * std::sin(pitch);
    const Shape position = shape_of(blend_position<double>, guides, {0.6, 0.4});
    const Shape detail = shape_of(blend_detail<double>, guides, {0.6, 0.4});
    EXPECT_NEAR(detail.kappa / kappa, 1, 0.01);
    // In space the spine keeps the mean of the guides' advances, cos(pitch), where places
    // lose the cosine of the angle that they stand off the mean: 1 - 0.2^2 / 2.
    EXPECT_NEAR(detail.chord.norm() / kLength, std::cos(pitch), 0.01);
    EXPECT_LT((detail.chord.normalized() - position.chord.normalized()).norm(), 0.01);
    EXPECT_LT((detail.chord - position.chord).norm(), 0.03 * kLength);
}

TEST(Detail, GetsOnAsFastAsTheMeanOfItsGuides) {
    // One tight curl, one open, about one axis: the advance is the mean of the cosines.
    Guides guides;
    add_curl(guides, Vec3(1, 0, 0), 10, 0.9, 0);
    add_curl(guides, Vec3(1, 0, 0), 10, 0.5, 1);
    const double mean = 0.5 * (std::cos(0.9) + std::cos(0.5));
    for (const std::vector<double>& weights :
         {std::vector{0.501, 0.499}, {0.499, 0.501}}) {
        const Shape detail = shape_of(blend_detail<double>, guides, weights);
        // Of the way from its own cosine to the mean, 0.13, the softening leaves out
        // 0.05 / (1 - a c), a tenth: 0.013. The curl's own share in the spine,
        // sin(pitch) / (10 pi), moves the advance by as much again.
        EXPECT_NEAR(detail.chord.norm() / kLength, mean, 0.025);
        EXPECT_GT(std::abs(shape_of(blend_nearest<double>, guides, weights).chord.norm() /
                               kLength -
                           mean),
                  0.1);
    }
}

TEST(Anchor, LeavesAStrandAloneWhoseGuidesAgreeWithIt) {
    // Guides alike but for their roots: every weight gives the same strand.
    Guides guides;
    for (int g = 0; g < 3; ++g) add_curl(guides, Vec3(1, 0.3, 0), 7.3, 0.7, 0.4);
    const auto profiles = guide_profiles<double>(guides, kCount);
    const MadeChild<double> made(profiles, {0.2, 0.5, 0.3});
    std::vector<HelixState<double>> states(kCount + 1), alone(kCount + 1);
    blend_nearest<double>(made.child(), profiles, alone);
    blend_detail<double>(made.child(), profiles, states);
    for (int i = 0; i <= kCount; ++i) {
        EXPECT_LT((states[i].position - alone[i].position).norm(), 1e-10);
    }
}

TEST(Anchor, CurlsKeepTheirSizeOnAChildOfAnotherLength) {
    // Guides of 20 and 10 cm with one curvature and torsion: the child of 15 cm has them
    // too, and so three quarters of the longer one's turns.
    Guides guides;
    const Vec3 u(1.5, 0, 1.2);
    test::add_guide(guides, std::vector<Vec3>(8, u), 20);
    test::add_guide(guides, std::vector<Vec3>(8, u), 10);
    const Shape detail = shape_of(blend_detail<double>, guides, {0.5, 0.5});
    EXPECT_NEAR(detail.kappa / 1.2, 1, 0.01);
}

TEST(Anchor, NothingJumpsWhereSpinesAreOpposed) {
    // A guide swings past the direction opposite to the others' spine. Halving its step
    // halves what the child moves by: the turn from one spine to the other goes through
    // none at all and not from half a turn one way to half a turn the other way.
    double largest[2];
    for (int fine = 0; fine < 2; ++fine) {
        const int steps = fine ? 4000 : 2000;
        std::vector<HelixState<double>> before, states(49);
        largest[fine] = 0;
        for (int i = 0; i <= steps; ++i) {
            const double angle = std::numbers::pi * (0.9 + 0.2 * i / steps);
            Guides guides;
            add_curl(guides, Vec3(std::cos(angle), std::sin(angle), 1e-3), 3, 0.5, 0);
            add_curl(guides, Vec3(1, 0, 0), 3, 0.5, 1);
            const auto profiles = guide_profiles<double>(guides, 48);
            const MadeChild<double> made(profiles, {0.4, 0.6});
            blend_detail<double>(made.child(), profiles, states);
            for (int j = 0; j <= 48 && i > 0; ++j) {
                const double moved = (states[j].position - before[j].position).norm();
                largest[fine] = std::max(largest[fine], moved);
            }
            before = states;
        }
    }
    EXPECT_NEAR(largest[1] / largest[0], 0.5, 0.02);
}

}  // namespace
}  // namespace lancret
