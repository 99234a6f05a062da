#include "sim/wind.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace lancret {
namespace {

WindSettings gusts(std::uint64_t seed) {
    WindSettings s;
    s.mean = {200, -30, 50};
    s.turbulence = 120;
    s.seed = seed;
    return s;
}

struct Event {
    Vec3 x;
    double t;
};

/// Uniform over ranges of hundreds of the largest wavelengths and periods.
Event random_event(std::mt19937& random) {
    std::uniform_real_distribution<double> coordinate(-5000, 5000), time(0, 100);
    return {{coordinate(random), coordinate(random), coordinate(random)}, time(random)};
}

TEST(Wind, MeanAndStrengthAreThoseOfTheSettings) {
    // Means over independent positions and times. Each is beyond 4.5 standard errors once
    // in 1.5e5; with 20 seeds of 4 means each, one fails in 1,800 runs with other random
    // numbers. In a box of 10^4 cm and 100 s the mean of a wave of l cm is at most
    // l / (pi 10^4): 1e-3 of its amplitude, far below the error at this count.
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const WindSettings settings = gusts(seed);
        const Wind wind = make_wind(settings);
        std::mt19937 random(unsigned(seed) + 1);
        Vec3 sum = Vec3::Zero(), squares = Vec3::Zero();
        double strength = 0, fourth = 0;
        constexpr int kCount = 10000;
        for (int i = 0; i < kCount; ++i) {
            const auto [x, t] = random_event(random);
            const Vec3 v = wind_velocity(wind, x, t) - settings.mean;
            sum += v;
            squares += v.cwiseAbs2();
            strength += v.squaredNorm();
            fourth += v.squaredNorm() * v.squaredNorm();
        }
        for (int c = 0; c < 3; ++c) {
            EXPECT_LT(std::abs(sum[c]), 4.5 * std::sqrt(squares[c]));
        }
        const double mean = strength / kCount;
        const double error = std::sqrt((fourth / kCount - mean * mean) / kCount);
        EXPECT_LT(std::abs(mean - 120 * 120), 4.5 * error);
        EXPECT_LT(error, 0.02 * 120 * 120);
    }
}

TEST(Wind, StrengthIsTheSameInEachDirectionOverSeeds) {
    // Over many seeds the mean square along an axis is a third of the total. Seeds are
    // independent, so the standard error is that of their mean.
    double sum[3] = {}, squares[3] = {};
    constexpr int kSeeds = 2000;
    for (int seed = 0; seed < kSeeds; ++seed) {
        const Wind wind = make_wind(gusts(std::uint64_t(seed)));
        Vec3 power = Vec3::Zero();
        for (const WindWave& w : wind.waves) power += w.amplitude.cwiseAbs2() / 2;
        EXPECT_NEAR(power.sum(), 120 * 120, 1e-8);
        for (int c = 0; c < 3; ++c) sum[c] += power[c], squares[c] += power[c] * power[c];
    }
    for (int c = 0; c < 3; ++c) {
        const double mean = sum[c] / kSeeds;
        const double error = std::sqrt((squares[c] / kSeeds - mean * mean) / kSeeds);
        EXPECT_LT(std::abs(mean - 120 * 120 / 3.0), 4.5 * error);
    }
}

TEST(Wind, HasNoDivergence) {
    const Wind wind = make_wind(gusts(7));
    std::mt19937 random(1);
    // Central differences of step h of a wave are off by h^2 |k|^3 |a| / 6; the largest
    // |k| is 4 x 2 pi / 20. Round-off of phases near 2e4 rad is 4e-12 |a| / h.
    const double h = 1e-2, k = 4 * 2 * kPi / 20;
    double amplitudes = 0, gradient = 0;
    for (const WindWave& w : wind.waves) amplitudes += w.amplitude.norm();
    const double tolerance = amplitudes * (h * h * k * k * k / 6 + 4e-12 / h);
    for (int i = 0; i < 200; ++i) {
        const auto [x, t] = random_event(random);
        double divergence = 0;
        for (int c = 0; c < 3; ++c) {
            const Vec3 step = h * Vec3::Unit(c);
            const Vec3 slope =
                (wind_velocity(wind, x + step, t) - wind_velocity(wind, x - step, t)) /
                (2 * h);
            divergence += slope[c];
            gradient = std::max(gradient, slope.norm());
        }
        EXPECT_LT(std::abs(divergence), tolerance);
    }
    EXPECT_GT(gradient, 1e3 * tolerance);
}

TEST(Wind, GustsAreCarriedByTheMeanWind) {
    // Seen drifting with the mean wind, an octave repeats with its period.
    WindSettings settings = gusts(3);
    settings.octaves = 1;
    const Wind wind = make_wind(settings);
    const Vec3 x(1, 2, 3);
    for (const double t : {0.0, 0.13, 0.4}) {
        const double later = t + settings.time_scale;
        EXPECT_LT((wind_velocity(wind, x + t * settings.mean, t) -
                   wind_velocity(wind, x + later * settings.mean, later))
                      .norm(),
                  1e-10);
        EXPECT_GT((wind_velocity(wind, x, t) - wind_velocity(wind, x, later)).norm(), 1);
    }
}

TEST(Wind, SeedsDiffer) {
    const Vec3 x(1, 2, 3);
    EXPECT_EQ(wind_velocity(make_wind(gusts(1)), x, 0.5),
              wind_velocity(make_wind(gusts(1)), x, 0.5));
    EXPECT_GT((wind_velocity(make_wind(gusts(1)), x, 0.5) -
               wind_velocity(make_wind(gusts(2)), x, 0.5))
                  .norm(),
              1);
}

TEST(Wind, WithoutTurbulenceIsItsMean) {
    WindSettings settings = gusts(1);
    settings.turbulence = 0;
    const Wind wind = make_wind(settings);
    EXPECT_TRUE(wind.waves.empty());
    EXPECT_EQ(wind_velocity(wind, {4, 5, 6}, 7), settings.mean);
}

TEST(Wind, RejectsInvalidSettings) {
    const double nan = std::nan("");
    const auto rejects = [](auto&& change) {
        WindSettings settings = gusts(1);
        change(settings);
        EXPECT_THROW(make_wind(settings), std::invalid_argument);
    };
    rejects([&](WindSettings& s) { s.mean.y() = nan; });
    rejects([&](WindSettings& s) { s.turbulence = nan; });
    rejects([&](WindSettings& s) { s.turbulence = -1; });
    rejects([&](WindSettings& s) { s.length_scale = 0; });
    rejects([&](WindSettings& s) { s.time_scale = -1; });
    rejects([&](WindSettings& s) { s.octaves = 0; });
    rejects([&](WindSettings& s) { s.octaves = 1000; });
    rejects([&](WindSettings& s) { s.waves_per_octave = 0; });
}

}  // namespace
}  // namespace lancret
