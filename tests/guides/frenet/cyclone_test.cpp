#include "guides/frenet/cyclone.h"
#include "tests/guides/frenet/frenet_paths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lancret {
namespace {

const std::vector<Cyclone> kCyclones{{0.5, 0.15, 0.3, 8},   // opens
                                     {2.0, -0.2, -0.6, 8},  // closes, left-handed
                                     {1.0, 0.0, 0.8, 8},    // a helix
                                     {1.0, 1e-12, 0.8, 8},  // nearly one
                                     {0.7, 0.2, 0.0, 8}};   // a plane logarithmic spiral

TEST(Cyclone, TurnIsTheIntegralOfCurvature) {
    // dq/ds = 1 / (radius + growth s), by central differences: an error of d^2 / 6 q''' =
    // d^2 / 3 growth^2 kappa^3, and q of up to 16 has round-off of 4e-15 / d.
    const double d = 1e-4;
    for (const Cyclone& c : kCyclones) {
        EXPECT_EQ(cyclone_turn(c, 0), 0);
        for (double s : {0.5, 3.0, 7.5}) {
            const double slope =
                (cyclone_turn(c, s + d) - cyclone_turn(c, s - d)) / (2 * d);
            const double kappa = 1 / (c.radius + c.growth * s);
            const double cut = d * d / 3 * c.growth * c.growth * std::pow(kappa, 3);
            EXPECT_NEAR(slope, kappa, 1.01 * cut + 4e-15 / d);
        }
    }
}

TEST(Cyclone, ClosedPositionsAreTheIntegralOfTheTangent) {
    for (const Cyclone& c : kCyclones) {
        const auto closed = cyclone_strand(c, skew_root(), 64);
        const auto integrated =
            constant_helicity_strand(constant_helicity(c, skew_root()), 64);
        for (int i = 0; i <= 64; ++i) {
            EXPECT_LT((closed[i].position - integrated[i].position).norm(), 1e-13);
            EXPECT_LT((closed[i].frame - integrated[i].frame).norm(), 1e-14);
        }
    }
}

TEST(Cyclone, WithoutGrowthIsAHelix) {
    HelixState<double> state = skew_root();
    advance<double>(state, Vec3(0.8, 0, 1), 5.0);
    EXPECT_LT(
        (cyclone_state(kCyclones[2], skew_root(), 5).position - state.position).norm(),
        1e-14);
}

TEST(Cyclone, PlaneCycloneIsALogarithmicSpiral) {
    // With the root at the origin along x, x + i y is the integral of e^(i q), that is
    // (radius(s) e^(i q) - radius(0)) / (m + i): a logarithmic spiral about the pole
    // -radius(0) / (m + i), at distance radius(s) / |m + i|.
    const Cyclone& c = kCyclones[4];
    const double m = c.growth, size2 = 1 + m * m;
    const Vec3 pole(-c.radius * m / size2, c.radius / size2, 0);
    const auto strand = cyclone_strand(c, {}, 20);
    for (int i = 0; i <= 20; ++i) {
        EXPECT_NEAR((strand[i].position - pole).norm(),
                    (c.radius + m * c.length * i / 20) / std::sqrt(size2), 1e-14);
    }
}

TEST(Cyclone, SynthesisConvergesAtOrderTwo) {
    for (const Cyclone& c : kCyclones) {
        if (std::abs(c.growth) < 1e-6) continue;  // a helix is exact at any step
        double previous = 0;
        for (int n : {100, 200, 400, 800}) {
            const auto closed = cyclone_strand(c, skew_root(), n);
            const auto numeric = synthesize(
                constant_helicity_profile(constant_helicity(c, skew_root()), n));
            double error = 0;
            for (int i = 0; i <= n; ++i) {
                error =
                    std::max(error, (closed[i].position - numeric[i].position).norm());
            }
            if (previous > 0) {
                const double order = std::log2(previous / error);
                std::printf("growth %g, n = %d: error %.3g, order %.2f\n", c.growth, n,
                            error, order);
                EXPECT_NEAR(order, 2.0, 0.05);
            }
            previous = error;
        }
    }
}

TEST(Cyclone, RejectsARadiusThatVanishes) {
    for (const Cyclone& c :
         {Cyclone{0, 1, 0, 1}, Cyclone{1, -1, 0, 1}, Cyclone{1, 0, 0, -1}}) {
        EXPECT_THROW(cyclone_state(c, {}, 0), std::invalid_argument);
        EXPECT_THROW(constant_helicity(c, {}), std::invalid_argument);
    }
}

}  // namespace
}  // namespace lancret
