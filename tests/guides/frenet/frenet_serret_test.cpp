#include "guides/frenet/frenet_serret.h"
#include "tests/guides/frenet/frenet_paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <unsupported/Eigen/MatrixFunctions>

namespace lancret {
namespace {

/// A root frame without zeros.
/// A profile of n random helices; each turns by at most `turn`.
FrenetProfile random_profile(int n, double turn, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    FrenetProfile profile{skew_root(), {}, {}};
    for (int i = 0; i < n; ++i) {
        const double ds = 0.3 * (1.5 + uniform(random)), limit = turn / ds / std::sqrt(2);
        profile.steps.push_back(ds);
        profile.rates.push_back({limit * uniform(random), limit * uniform(random)});
    }
    return profile;
}

/// The largest difference of the turns kappa ds and tau ds between two profiles.
double turn_difference(const FrenetProfile& a, const FrenetProfile& b) {
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        worst = std::max(
            worst, (a.rates[i].darboux() - b.rates[i].darboux()).norm() * a.steps[i]);
    }
    return worst;
}

TEST(FrenetSerret, StepIsTheExponentialOfThePapersMatrix) {
    // F(s + ds) = exp(Q ds) F(s) with rows T, N, B [TW99, Eq. 11 and 26].
    const double kappa = 1.3, tau = -0.6, ds = 0.9;
    FrenetProfile profile{skew_root(), {ds}, {{kappa, tau}}};
    Mat3 q;
    q << 0, kappa, 0, -kappa, 0, tau, 0, -tau, 0;
    const Mat3 rows = (q * ds).exp() * profile.root.frame.transpose();
    EXPECT_LT((synthesize(profile)[1].frame - rows.transpose()).norm(), 1e-14);
}

TEST(FrenetSerret, CircleClosesInSixSteps) {
    // [TW99, Eq. 37] as printed would give a radius of 0.866 here.
    FrenetProfile profile{skew_root(), std::vector(6, kPi / 3 * 2), {}};
    profile.rates.assign(6, {0.5, 0});
    const auto states = synthesize(profile);
    const Vec3 centre = states[0].position + 2 * states[0].frame.col(1);
    for (const auto& state : states) {
        EXPECT_NEAR((state.position - centre).norm(), 2, 1e-14);
    }
    EXPECT_LT((states[6].position - states[0].position).norm(), 1e-14);
}

TEST(FrenetSerret, TorsionOfARightHandedHelixIsPositive) {
    // (cos v, sin v, b v) is right-handed for b > 0, kappa = 1 / (1 + b^2), tau = b
    // kappa.
    for (double b : {0.7, -0.7}) {
        const double w = std::sqrt(1 + b * b), ds = 0.4;
        const auto frame_at = [&](double s) {
            const double v = s / w;
            Mat3 f;
            f.col(0) = Vec3(-std::sin(v), std::cos(v), b) / w;
            f.col(1) = Vec3(-std::cos(v), -std::sin(v), 0);
            f.col(2) = f.col(0).cross(f.col(1));
            return f;
        };
        const FrenetRates rates =
            frenet_step(frame_at(1.1).transpose() * frame_at(1.1 + ds), ds);
        EXPECT_NEAR(rates.curvature, 1 / (w * w), 1e-14);
        EXPECT_NEAR(rates.torsion, b / (w * w), 1e-14);
    }
}

TEST(FrenetSerret, StraightProfileIsALine) {
    FrenetProfile profile{skew_root(), std::vector(50, 0.2), {}};
    profile.rates.resize(50);
    const auto states = synthesize(profile);
    EXPECT_LT(
        (states[50].position - states[0].position - 10 * states[0].frame.col(0)).norm(),
        1e-13);
    const FrenetProfile back = profile_of_frames(states, profile.steps);
    EXPECT_LT(turn_difference(profile, back), 1e-15);
}

TEST(FrenetSerret, AnalysisInvertsSynthesis) {
    // The frames are accurate to a few units of round-off, and so are the turns: b and e
    // determine them up to a quarter turn, and beyond it a, c and f, over 1 - d > 1.
    for (double turn : {1e-9, 1e-6, 1e-3, 1.0, 2.0, 3.0}) {
        const FrenetProfile profile = random_profile(300, turn, 5);
        const FrenetProfile back = profile_of_frames(synthesize(profile), profile.steps);
        EXPECT_LT(turn_difference(profile, back), 2e-14) << turn;
        EXPECT_LE(largest_turn(back), turn * (1 + 1e-12));
        EXPECT_EQ(back.root.position, profile.root.position);
    }
}

TEST(FrenetSerret, RatesAgreeWithTheLogarithmOfTheRotation) {
    for (double turn : {1e-7, 0.5, 1.7, 3.1}) {
        const Vec3 w = turn * Vec3(0.6, 0, -0.8);
        const Mat3 rotation = helix_step<double>(w, 1).rotation;
        const Vec3 log = rotation_log<double>(rotation);
        EXPECT_LT((frenet_step(rotation, 1).darboux() - log).norm(), 1e-14 * (1 + turn));
    }
}

TEST(FrenetSerret, TurnsOverPiAliasUnlessExpected) {
    // Omega ds = 2 sqrt(5) = 4.47 is seen as a turn of 2 pi - 4.47 the other way.
    const FrenetRates truth{2, 1};
    const Mat3 rotation = helix_step<double>(truth.darboux(), 2).rotation;
    const double alias = 1 - kPi / std::sqrt(5.0);
    const FrenetRates seen = frenet_step(rotation, 2);
    EXPECT_NEAR(seen.curvature, 2 * alias, 1e-14);
    EXPECT_NEAR(seen.torsion, alias, 1e-14);
    const FrenetRates unwrapped = frenet_step(rotation, 2, FrenetRates{1.6, 1.3});
    EXPECT_NEAR(unwrapped.curvature, 2, 1e-14);
    EXPECT_NEAR(unwrapped.torsion, 1, 1e-14);
}

TEST(FrenetSerret, ExpectedRatesUnwrapAnyNumberOfTurns) {
    const FrenetProfile profile = random_profile(300, 40, 6);
    std::vector<FrenetRates> about = profile.rates;
    for (std::size_t i = 0; i < about.size(); ++i) {
        about[i].curvature += 1 / profile.steps[i];
        about[i].torsion -= 1 / profile.steps[i];
    }
    const FrenetProfile back =
        profile_of_frames(synthesize(profile), profile.steps, about);
    // The error of the axis is a few 1e-16 over the turn's distance from a multiple of 2
    // pi, which for 300 turns spread over 40 radians is at least about 5e-3.
    EXPECT_LT(turn_difference(profile, back), 40 * 5e-16 / 5e-3);
    EXPECT_GT(largest_turn(back), 20);
}

TEST(FrenetSerret, RejectsMismatchedSizes) {
    const std::vector<HelixState<double>> states(3);
    const std::vector<double> steps(3, 1.0);
    EXPECT_THROW(profile_of_frames(states, steps), std::invalid_argument);
    const std::vector<FrenetRates> one(1);
    EXPECT_THROW(profile_of_frames(states, std::span(steps).first(2), one),
                 std::invalid_argument);
}

}  // namespace
}  // namespace lancret
