#include "guides/frenet/frenet_analysis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/guides/frenet/frenet_paths.h"

namespace lancret {
namespace {

/// Order 2: halving the step leaves a quarter of the error. The order is asserted within
/// `band`, for the terms of the next order.
void expect_order_two(const std::function<double(int)>& error, const char* name,
                      double band = 0.05) {
    for (int n : {80, 160, 320}) {
        const double order = std::log2(error(n) / error(2 * n));
        std::printf("%s, n = %d: error %.3g, order %.2f\n", name, n, error(n), order);
        EXPECT_NEAR(order, 2.0, band) << name << " " << n;
    }
}

TEST(FrenetRoundTrip, TwistedCubicIsRecoveredAtOrderTwo) {
    for (const auto& [method, name] : {std::pair(FrenetMethod::frames, "frames"),
                                       std::pair(FrenetMethod::point_values, "points")}) {
        expect_order_two(
            [&](int n) {
                return round_trip_error(sampled(twisted_cubic, -1, 1.2, n), method);
            },
            name);
    }
}

TEST(FrenetRoundTrip, InflectionOfACubicIsRecoveredAtOrderTwo) {
    // On -1 .. 1 a sample falls on the inflection; on -1 .. 1.1 none does.
    expect_order_two(
        [](int n) {
            return round_trip_error(sampled(cubic_inflection, -1, 1, n),
                                    FrenetMethod::frames);
        },
        "x^3");
    expect_order_two(
        [](int n) {
            return round_trip_error(sampled(cubic_inflection, -1, 1.1, n),
                                    FrenetMethod::frames);
        },
        "x^3 off the samples");
}

/// A path whose curvature and torsion vary.
Vec3 wave(double v) { return helix(v, 1 + 0.2 * std::sin(v), 0.4).position; }

Curve wave_spline(int n) {
    std::vector<Vec3> points;
    for (int i = 0; i <= n; ++i) points.push_back(wave(6.0 * i / n));
    return *curve_through(points);
}

TEST(FrenetRoundTrip, SplineThroughPointsIsRecoveredAtOrderTwo) {
    // Points and intervals are refined together. (On one spline the order varies from 1.6
    // to 2.2, depending on where the kinks of its curvature at the knots fall in the
    // intervals, and leaves the band of 0.2 used here.)
    expect_order_two(
        [&](int n) {
            const Curve curve = wave_spline(n);
            const auto strand = synthesize(analyze(curve, n, Vec3::UnitZ()));
            const SampledCurve exact = resample(curve, n);
            double worst = 0;
            for (int i = 0; i <= n; ++i) {
                worst = std::max(worst, (strand[i].position - exact.positions[i]).norm());
            }
            return worst;
        },
        "spline", 0.2);
}

TEST(FrenetRoundTrip, JaggedStrandsConverge) {
    // Points of a random walk: the spline's curvature passes near zero all the time, and
    // N swings there. Nothing is smooth, so no order is asserted, only that 16 times the
    // intervals reduce the error to less than a tenth (order 1 would give a 16th).
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 3; ++trial) {
        std::vector<Vec3> points{Vec3::Zero()};
        for (int i = 0; i < 30; ++i) {
            points.push_back(points.back() +
                             Vec3(1 + normal(random), normal(random), normal(random)));
        }
        const Curve curve = *curve_through(points);
        const auto tip_error = [&](int n) {
            const auto strand = synthesize(analyze(curve, n, Vec3::UnitZ()));
            return (strand.back().position - points.back()).norm();
        };
        EXPECT_LT(tip_error(6400), 0.1 * tip_error(400)) << trial;
    }
}

TEST(FrenetRoundTrip, CoarseProfileOfAHelixLosesNoTurn) {
    // Six turns of a helix in 9 intervals: Omega ds = 2 pi 6 / 9 = 4.19 > pi.
    std::vector<Vec3> points;
    for (int i = 0; i <= 400; ++i) {
        points.push_back(helix(12 * kPi * i / 400, 1, -0.5).position);
    }
    const FrenetProfile profile = analyze(*curve_through(points), 9, Vec3::UnitZ());
    // The spline is within h^2 = 0.01 of the curvature at its ends and far less inside.
    for (const FrenetRates& r : profile.rates) {
        EXPECT_NEAR(r.curvature, 1 / 1.25, 1e-2);
        EXPECT_NEAR(r.torsion, -0.5 / 1.25, 1e-2);
    }
    EXPECT_GT(largest_turn(profile), kPi);
}

TEST(FrenetRoundTrip, SynthesizedLengthIsTheCurves) {
    const Curve curve = wave_spline(20);
    for (int n : {1, 7, 100}) {
        const FrenetProfile profile = analyze(curve, n, Vec3::UnitZ());
        double length = 0;
        for (double ds : profile.steps) length += ds;
        EXPECT_NEAR(length, curve.length(), 1e-13);
    }
    EXPECT_THROW(analyze(curve, 0, Vec3::UnitZ()), std::invalid_argument);
}

}  // namespace
}  // namespace lancret
