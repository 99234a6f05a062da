#include <gtest/gtest.h>

#include "guides/helix/super_helix.h"
#include "procedural/blend/blend.h"
#include "tests/procedural/made_guides.h"

namespace lancret {
namespace {

using test::add_guide;
using test::MadeChild;

template <class T>
std::vector<HelixState<T>> states_of(const GuideProfiles<T>& profiles,
                                     std::vector<T> weights) {
    std::vector<HelixState<T>> states(profiles.count + 1);
    const MadeChild<T> made(profiles, std::move(weights));
    blend_option1<T>(made.child(), profiles, states);
    return states;
}

/// kappa of interval i, from the rotation between its ends.
double kappa_of(const std::vector<HelixState<double>>& states, int i, double ds) {
    const Mat3 turn = states[i].frame.transpose() * states[i + 1].frame;
    const Vec3 w = rotation_log<double>(turn) / ds;
    return std::hypot(w.y(), w.z());
}

TEST(Option1, WithAllWeightOnAGuideIsThatGuide) {
    for (unsigned seed = 0; seed < 50; ++seed) {
        const Guides guides = test::random_guides(1, 8, seed);
        const auto profiles = guide_profiles<double>(guides, 24);
        const auto states = states_of<double>(profiles, {1.0});
        const double length = guide_length(guides, 0);
        for (int i = 0; i <= 24; ++i) {
            const HelixState<double> exact =
                state_at(super_helix(guides, 0), length * i / 24);
            EXPECT_LT(
                (states[i].position + guides.root_positions[0] - exact.position).norm(),
                1e-9 * length);
        }
    }
}

TEST(Option1, KeepsTheTurnOfTheNormalAtAStraightSegmentAndAnInflection) {
    Guides guides;
    // Bends one way, is straight, bends back, then bends in another plane.
    add_guide(guides, {{0, 0, 0.3}, {0, 0, 0}, {0, 0, -0.3}, {0.2, 0.3, 0.1}}, 12);
    const auto profiles = guide_profiles<double>(guides, 8);
    const auto states = states_of<double>(profiles, {1.0});
    const HelixState<double> tip = state_at(super_helix(guides, 0), 12);
    EXPECT_LT((states[8].position - tip.position).norm(), 1e-9 * 12);
    // N is carried over the straight segment, and turns by half a turn at its end.
    const auto& row = profiles.intervals;
    EXPECT_LT((row[2].normal_before - row[1].normal_after).norm(), 1e-12);
    EXPECT_LT((row[4].normal_before + row[3].normal_after).norm(), 1e-12);
}

TEST(Option1, TwoPlanarGuidesGiveThePrintedFormula) {
    // Circles in one plane: at s the tangents are at angles kappa s, T~ is between them
    // at phi, and the printed formula is sum w kappa cos(kappa s - phi) / sum w cos(kappa
    // s - phi). Up to a length of 7 the guides stay within a right angle of each other.
    const double kappa[] = {0.1, 0.3}, weight[] = {0.25, 0.75};
    Guides guides;
    for (const double k : kappa) {
        add_guide(guides, std::vector<Vec3>(4, Vec3(0, 0, k)), 7);
    }
    const auto profiles = guide_profiles<double>(guides, 16);
    const auto states = states_of<double>(profiles, {weight[0], weight[1]});
    const double ds = 7.0 / 16;
    for (int i = 0; i < 16; ++i) {
        const double s = (i + 0.5) * ds;
        double x = 0, y = 0, top = 0, bottom = 0;
        for (int k = 0; k < 2; ++k) {
            x += weight[k] * std::cos(kappa[k] * s);
            y += weight[k] * std::sin(kappa[k] * s);
        }
        for (int k = 0; k < 2; ++k) {
            const double across = weight[k] * std::cos(kappa[k] * s - std::atan2(y, x));
            top += kappa[k] * across;
            bottom += across;
        }
        // kSteady changes the quotient by at most 1e-5 of its distance to the mean, 1e-2
        // here.
        EXPECT_NEAR(kappa_of(states, i, ds), top / bottom, 3e-6);
    }
    for (const auto& state : states) EXPECT_NEAR(state.position.z(), 0, 1e-12);
}

TEST(Option1, StaysInsideTheHullIfNormalsOppose) {
    // kappa 1 and 3 with normals 179.9 degrees apart: 1146 by the printed formula.
    const double apart = 179.9 * kPi / 180;
    Guides guides;
    add_guide(guides, {Vec3(0, 0, 1)}, 2);
    add_guide(guides, {Vec3(0, -3 * std::sin(apart), 3 * std::cos(apart))}, 2);
    const auto profiles = guide_profiles<double>(guides, 16);
    for (double w = 0; w <= 1; w += 0.05) {
        const auto states = states_of<double>(profiles, {w, 1 - w});
        for (int i = 0; i < 16; ++i) {
            const double kappa = kappa_of(states, i, 2.0 / 16);
            EXPECT_GE(kappa, 1 - 1e-9);
            EXPECT_LE(kappa, 3 + 1e-9);
        }
    }
}

TEST(Option1, KappaAndTauStayInsideTheHullOfRandomGuides) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        const Guides guides = test::random_guides(4, 4, seed);
        const auto profiles = guide_profiles<double>(guides, 12);
        const auto states = states_of<double>(profiles, {0.4, 0.3, 0.2, 0.1});
        const double ds = (0.4 * profiles.lengths[0] + 0.3 * profiles.lengths[1] +
                           0.2 * profiles.lengths[2] + 0.1 * profiles.lengths[3]) /
                          12;
        for (int i = 0; i < 12; ++i) {
            double kappa_high = 0, tau_low = 1e9, tau_high = -1e9;
            for (int g = 0; g < 4; ++g) {
                const Vec3& u = guides.curvatures[g * 4 + i / 3];
                kappa_high = std::max(kappa_high, std::hypot(u.y(), u.z()));
                tau_low = std::min(tau_low, u.x());
                tau_high = std::max(tau_high, u.x());
            }
            const Vec3 w =
                rotation_log<double>(states[i].frame.transpose() * states[i + 1].frame) /
                ds;
            EXPECT_LE(std::hypot(w.y(), w.z()), kappa_high + 1e-9);
            EXPECT_GE(w.x(), tau_low - 1e-9);
            EXPECT_LE(w.x(), tau_high + 1e-9);
        }
    }
}

TEST(Option1, FloatFramesAreOrthonormalEvenOfOpposedRoots) {
    Guides guides = test::random_guides(2, 4, 7);
    guides.root_frames[1] =
        guides.root_frames[0] * Eigen::DiagonalMatrix<double, 3>(-1, -1, 1);
    const auto profiles = guide_profiles<float>(guides, 32);
    for (const auto& state : states_of<float>(profiles, {0.5f, 0.5f})) {
        EXPECT_LT((state.frame.transpose() * state.frame - Mat3f::Identity())
                      .cwiseAbs()
                      .maxCoeff(),
                  1e-6f);
        EXPECT_TRUE(state.position.allFinite());
    }
}

TEST(Option1, StraightGuidesGiveAStraightChild) {
    Guides guides;
    add_guide(guides, std::vector<Vec3>(2, Vec3::Zero()), 10);
    add_guide(guides, std::vector<Vec3>(2, Vec3::Zero()), 20);
    const auto profiles = guide_profiles<double>(guides, 4);
    const auto states = states_of<double>(profiles, {0.5, 0.5});
    EXPECT_LT((states[4].position - Vec3(15, 0, 0)).norm(), 1e-12);
}

}  // namespace
}  // namespace lancret
