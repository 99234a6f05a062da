#include "procedural/blend/anchor.h"

#include <gtest/gtest.h>

#include "tests/procedural/made_guides.h"

namespace lancret {
namespace {

using test::MadeChild;

constexpr int kAnchorIntervals = 240;
constexpr double kAnchoredLength = 20;

/// Appends a helix of `turns` turns about `axis`, with the given pitch angle to it.
void add_curl(Guides& guides, const Vec3& axis, double turns, double pitch,
              double phase) {
    const double omega = 2 * kPi * turns / kAnchoredLength;
    const Vec3 u(omega * std::cos(pitch), 0, omega * std::sin(pitch));
    // The root frame for which the Darboux vector is along the axis, rolled by the phase.
    const Mat3 frame = Eigen::AngleAxisd(phase, axis.normalized()) *
                       Eigen::Quaterniond::FromTwoVectors(u, axis).toRotationMatrix();
    test::add_guide(guides, std::vector<Vec3>(12, u), kAnchoredLength, frame);
}

struct Shape {
    Vec3 chord;
    double kappa;  ///< mean, 1/cm
};

Shape shape_of(BlendFunction<double> blend, const Guides& guides,
               const std::vector<double>& weights) {
    const auto profiles = guide_profiles<double>(guides, kAnchorIntervals);
    const MadeChild<double> made(profiles, weights);
    std::vector<HelixState<double>> states(kAnchorIntervals + 1);
    blend(made.child(), profiles, states);
    Shape out{states[kAnchorIntervals].position, 0};
    for (int i = 0; i < kAnchorIntervals; ++i) {
        const Mat3 turn = states[i].frame.transpose() * states[i + 1].frame;
        const Vec3 u = rotation_log<double>(turn) * (kAnchorIntervals / made.length);
        out.kappa += std::hypot(u.y(), u.z()) / kAnchorIntervals;
    }
    return out;
}

TEST(Detail, KeepsPositionAndCurlOfCurlsOfDifferentPhase) {
    // Two curls of opposite phase about axes 0.4 radian apart. Averaged positions cancel
    // to a straight strand; detail has the curvature of one curl and the same end.
    const double pitch = 0.8, turns = 10;
    Guides guides;
    add_curl(guides, Vec3(1, 0.2, 0), turns, pitch, 0);
    add_curl(guides, Vec3(1, -0.2, 0), turns, pitch, kPi);
    const double kappa = 2 * kPi * turns / kAnchoredLength * std::sin(pitch);
    const Shape position = shape_of(blend_position<double>, guides, {0.6, 0.4});
    const Shape detail = shape_of(blend_detail<double>, guides, {0.6, 0.4});
    EXPECT_NEAR(detail.kappa / kappa, 1, 0.01);
    // The spine keeps the mean of the guides' advances, cos(pitch), while averaged
    // positions lose the cosine of the axes' angle to the mean: 1 - 0.2^2 / 2.
    EXPECT_NEAR(detail.chord.norm() / kAnchoredLength, std::cos(pitch), 0.01);
    EXPECT_LT((detail.chord.normalized() - position.chord.normalized()).norm(), 0.01);
    EXPECT_LT((detail.chord - position.chord).norm(), 0.03 * kAnchoredLength);
}

TEST(Detail, AdvancesAsFastAsTheMeanOfItsGuides) {
    // One tight curl, one open, about one axis: the advance is the mean of the cosines.
    Guides guides;
    add_curl(guides, Vec3(1, 0, 0), 10, 0.9, 0);
    add_curl(guides, Vec3(1, 0, 0), 10, 0.5, 1);
    const double mean = 0.5 * (std::cos(0.9) + std::cos(0.5));
    for (const std::vector<double>& weights :
         {std::vector{0.501, 0.499}, {0.499, 0.501}}) {
        const Shape detail = shape_of(blend_detail<double>, guides, weights);
        // The softening shortens the change from the guide's cosine to the mean, 0.13, by
        // 0.05 / (1 - a c), a tenth: 0.013. The curl's contribution to the spine,
        // sin(pitch) / (10 pi), moves the advance by as much again.
        EXPECT_NEAR(detail.chord.norm() / kAnchoredLength, mean, 0.025);
        EXPECT_GT(std::abs(shape_of(blend_nearest<double>, guides, weights).chord.norm() /
                               kAnchoredLength -
                           mean),
                  0.1);
    }
}

TEST(Anchor, LeavesAStrandUnchangedIfItsGuidesAgree) {
    // Guides that differ only in their roots: all weights give the same strand.
    Guides guides;
    for (int g = 0; g < 3; ++g) add_curl(guides, Vec3(1, 0.3, 0), 7.3, 0.7, 0.4);
    const auto profiles = guide_profiles<double>(guides, kAnchorIntervals);
    const MadeChild<double> made(profiles, {0.2, 0.5, 0.3});
    std::vector<HelixState<double>> states(kAnchorIntervals + 1),
        copy(kAnchorIntervals + 1);
    blend_nearest<double>(made.child(), profiles, copy);
    blend_detail<double>(made.child(), profiles, states);
    for (int i = 0; i <= kAnchorIntervals; ++i) {
        EXPECT_LT((states[i].position - copy[i].position).norm(), 1e-10);
    }
}

TEST(Anchor, CurlsKeepTheirSizeOnAChildOfAnotherLength) {
    // Guides of 20 and 10 cm with the same curvature and torsion: the child of 15 cm also
    // has them, and so three quarters of the longer guide's turns.
    Guides guides;
    const Vec3 u(1.5, 0, 1.2);
    test::add_guide(guides, std::vector<Vec3>(8, u), 20);
    test::add_guide(guides, std::vector<Vec3>(8, u), 10);
    const Shape detail = shape_of(blend_detail<double>, guides, {0.5, 0.5});
    EXPECT_NEAR(detail.kappa / 1.2, 1, 0.01);
}

TEST(Anchor, NothingJumpsIfSpinesAreOpposed) {
    // A guide swings past the direction opposite to the others' spine. Halving its step
    // halves the child's motion: the turn from one spine to the other passes through zero
    // instead of jumping from half a turn one way to half a turn the other way.
    double largest[2];
    for (int fine = 0; fine < 2; ++fine) {
        const int steps = fine ? 4000 : 2000;
        std::vector<HelixState<double>> before, states(49);
        largest[fine] = 0;
        for (int i = 0; i <= steps; ++i) {
            const double angle = kPi * (0.9 + 0.2 * i / steps);
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
