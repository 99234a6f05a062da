#include "procedural/blend/spine.h"

#include <gtest/gtest.h>

#include "guides/helix/helix.h"

namespace lancret {
namespace {

constexpr double kSpineLength = 12;

/// The spine of a helix with the Darboux vector u.
Spine<double> helix_spine(const Vec3& u, int count) {
    std::vector<Vec3> places;
    for (int i = 0; i <= count; ++i) {
        HelixState<double> state;
        advance<double>(state, u, kSpineLength * i / count);
        places.push_back(state.position);
    }
    return spine_of<double>(spine_basis<double>(count), kSpineLength,
                            [&](std::size_t i) { return places[i]; });
}

TEST(Spine, OfAStraightStrandIsItsTangent) {
    const auto basis = spine_basis<double>(16);
    const Spine<double> spine = helix_spine(Vec3::Zero(), 16);
    for (const double turns : {0.0, 5.0}) {
        for (int i = 0; i <= 16; ++i) {
            const Vec3 tangent = spine_at(spine, spine_taper(turns), basis.at_places[i]);
            // P_j is taken in the middle of each interval, so that its sum is zero only
            // for odd j; that of P_2 is 1 / (2 n^2), times five.
            EXPECT_LT((tangent - Vec3::UnitX()).norm(), 6.0 / (2 * 16 * 16));
        }
    }
}

TEST(Spine, FollowsAnArcToTheThirdOrder) {
    // T = (cos x, sin x) over x in [-a, a] about its middle: degrees 0 to 3 omit the next
    // term of the Taylor series, x^4 / 24, of which at most 8 / 35 remain at the ends.
    const double a = 0.5;
    const Vec3 u(0, 0, 2 * a / kSpineLength);
    const int n = 400;
    const auto basis = spine_basis<double>(n);
    const Spine<double> spine = helix_spine(u, n);
    for (int i = 0; i <= n; i += 50) {
        HelixState<double> state;
        advance<double>(state, u, kSpineLength * i / n);
        const Vec3 tangent = spine_at(spine, spine_taper(10.0), basis.at_places[i]);
        EXPECT_LT((tangent - state.frame.col(0)).norm(), a * a * a * a / 24 + 1e-4);
    }
}

TEST(Spine, AdvanceOfAHelixIsTheCosineOfItsPitchAngle) {
    // The part of a helix of N turns across its axis contributes at most (2 j + 1) / (pi
    // N) times the sine to degree j.
    const double turns = 20, pitch = 0.6;
    const double omega = 2 * kPi * turns / kSpineLength;
    const Vec3 u(omega * std::cos(pitch), 0, omega * std::sin(pitch));
    const Spine<double> spine = helix_spine(u, 2000);
    EXPECT_NEAR(spine.terms[0].norm(), std::cos(pitch), 1e-4);
    const Vec3 axis = u.normalized();
    EXPECT_NEAR(spine.terms[0].dot(axis), std::cos(pitch), 1e-4);
    for (int j = 1; j < kSpineTerms; ++j) {
        EXPECT_LT(spine.terms[j].norm(), (2 * j + 1) * std::sin(pitch) / (kPi * turns));
    }
}

TEST(Spine, HigherDegreesFadeInWithTheTurnsOfTheCurl) {
    EXPECT_EQ(spine_taper(0.0), (std::array<double, 4>{1, 1, 0, 0}));
    EXPECT_EQ(spine_taper(1.5), (std::array<double, 4>{1, 1, 0.5, 0}));
    EXPECT_EQ(spine_taper(2.25), (std::array<double, 4>{1, 1, 1, 0.25}));
    EXPECT_EQ(spine_taper(40.0), (std::array<double, 4>{1, 1, 1, 1}));
}

}  // namespace
}  // namespace lancret
