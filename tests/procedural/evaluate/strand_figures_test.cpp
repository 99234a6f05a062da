#include "procedural/evaluate/strand_figures.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace lancret {
namespace {

constexpr double kTwoPi = 2 * kPi;

/// `count` strands of `steps` steps whose point at the fraction t is place(strand, t).
StrandSamples strands_of(int count, int steps,
                         const std::function<Vec3(int, double)>& place) {
    StrandSamples out{steps, {}};
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j <= steps; ++j) {
            out.points.push_back(place(i, double(j) / steps));
        }
    }
    return out;
}

/// A helix about +Z of n steps that turn by w each, with radius r and rise h per radian;
/// right-handed if h is positive.
StrandSamples helix(double r, double h, double w, int n) {
    return strands_of(1, n, [&](int, double t) {
        const double a = w * n * t;
        return Vec3(r * std::cos(a), r * std::sin(a), h * a);
    });
}

/// 8 turns of radius 0.3 about 10 cm of +Z, starting at a phase.
Vec3 curl(double t, double phase) {
    const double a = kTwoPi * 8 * t + phase;
    return {0.3 * std::cos(a), 0.3 * std::sin(a), 10 * t};
}

TEST(StrandFigures, CurvatureIsTheTurnOfThePolylineOverItsStep) {
    // A chord spans 2 r sin(w/2) across and h w along; successive chords differ by the
    // angle w across.
    const double r = 1.3, h = 0.4, w = 0.3;
    const double across = 4 * r * r * std::pow(std::sin(w / 2), 2), along = h * h * w * w;
    const double chord = std::sqrt(across + along);
    const double turn = std::acos((across * std::cos(w) + along) / (chord * chord));
    std::vector<Weighted> found;
    add_curvatures(helix(r, h, w, 20).strand(0), found);
    ASSERT_EQ(found.size(), 19u);
    // The error of acos is about 1e-16 / turn^2, turn = 0.3.
    for (const Weighted& v : found) EXPECT_NEAR(v.value, turn / chord, 1e-13);
}

TEST(StrandFigures, TorsionOfAHelixConvergesAtOrderTwoWithItsSign) {
    const double r = 1, h = 0.5, tau = h / (r * r + h * h);
    const auto error = [&](double sign, double w) {
        std::vector<Weighted> found;
        add_torsions(helix(r, sign * h, w, 10).strand(0), found);
        EXPECT_EQ(found.size(), 8u);
        return found[4].value - sign * tau;
    };
    for (const double sign : {1.0, -1.0}) {
        // The error is c w^2 + O(w^4): halving w reduces it to 1/4, up to the next order.
        EXPECT_NEAR(error(sign, 0.05) / error(sign, 0.1), 0.25, 0.25 * 0.01);
        EXPECT_LT(std::abs(error(sign, 0.1)), tau * 0.01);
    }
}

TEST(StrandFigures, AStraightStrandHasNoWeightInTorsion) {
    std::vector<Weighted> found;
    add_torsions(strands_of(1, 8, [](int, double t) { return Vec3(0, 0, t); }).strand(0),
                 found);
    for (const Weighted& v : found) EXPECT_EQ(v.weight, 0);
    std::vector<Weighted> other = found;
    const DistributionFigures figures = compare(found, other);
    EXPECT_EQ(figures.w1, 0);
    EXPECT_EQ(figures.mean_ratio, 1);
}

TEST(StrandFigures, AShiftChangesThePlaceButNotTheShape) {
    const auto truth = strands_of(5, 64, [](int i, double t) { return curl(t, i); });
    const auto moved = strands_of(
        5, 64, [](int i, double t) { return Vec3(curl(t, i) + Vec3(0.3, 0, 0.4)); });
    const StrandFigures figures =
        strand_figures(truth, std::vector<double>(5, 20.0), moved);
    // 0.5 cm of 20, up to round-off.
    for (const Spread& spread : {figures.rms, figures.place, figures.tip}) {
        EXPECT_NEAR(spread.median, 0.025, 1e-14);
        EXPECT_NEAR(spread.p95, 0.025, 1e-14);
    }
    EXPECT_NEAR(figures.curvature.w1, 0, 1e-11);
    EXPECT_NEAR(figures.torsion.w1, 0, 1e-11);
    EXPECT_NEAR(figures.curvature.mean_ratio, 1, 1e-11);
}

TEST(StrandFigures, ACurlOfAnotherPhaseIsInPlaceExceptAtItsEnds) {
    const auto truth = strands_of(3, 64, [](int, double t) { return curl(t, 0); });
    const auto turned = strands_of(3, 64, [](int, double t) { return curl(t, kPi / 2); });
    const StrandFigures figures =
        strand_figures(truth, std::vector<double>(3, 20.0), turned);
    const double rms = 0.3 * std::numbers::sqrt2 / 20;  // r 2 sin(phase / 2)
    EXPECT_NEAR(figures.rms.median, rms, 1e-14);
    // In the interior the low-pass reduces the curl to exp(-(2 pi 8 0.08)^2 / 2) = 3e-4.
    // At x from an end it includes the end's offset with weight Phi(-x / sigma); both
    // ends together have the RMS sqrt(2 * 0.08 * integral of Phi(-y)^2 dy) = sqrt(0.16 *
    // 0.4674 / 4) = 0.137 of it. The remainder of the curl where the kernel is clamped is
    // at most 1 / (sqrt(2 pi) 2 pi 8 0.08) = 0.1 of 0.5 at the end: one fifth.
    EXPECT_NEAR(figures.place.median, rms * 0.137, rms * 0.137 / 5);
    EXPECT_NEAR(figures.curvature.w1, 0, 1e-11);
}

TEST(StrandFigures, MedianAndP95AreOverStrands) {
    const auto truth = strands_of(21, 8, [](int, double t) { return Vec3(0, 0, t); });
    const auto moved =
        strands_of(21, 8, [](int i, double t) { return Vec3(0.1 * i, 0, t); });
    const StrandFigures figures =
        strand_figures(truth, std::vector<double>(21, 1.0), moved);
    EXPECT_NEAR(figures.rms.median, 1.0, 1e-14);
    EXPECT_NEAR(figures.rms.p95, 1.9, 1e-14);
}

TEST(StrandFigures, QuantilesAreInterpolatedLinearly) {
    EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 0.5), 2.5);
    EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 0), 1);
    EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 1), 4);
    EXPECT_DOUBLE_EQ(quantile({10, 20}, 0.25), 12.5);
    EXPECT_EQ(quantile({}, 0.5), 0);
}

TEST(StrandFigures, DistanceOfDistributionsIsThatOfTheirQuantiles) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> even(1, 3);
    std::vector<Weighted> real, shifted, scaled;
    double mean = 0;
    for (int i = 0; i < 20000; ++i) {
        const double x = even(random);
        real.push_back({x, 1});
        shifted.push_back({x + 0.5, 1});
        scaled.push_back({1.2 * x, 1});
        mean += x / 20000;
    }
    // Every quantile moves by 0.5. Their mean magnitude is that of the values except for
    // the outer half per cents, at most 0.005 (3 - 1).
    const DistributionFigures moved = compare(real, shifted);
    EXPECT_NEAR(moved.w1, 0.5 / mean, 0.5 / mean * 0.01);
    EXPECT_NEAR(moved.mean_ratio, (mean + 0.5) / mean, 1e-12);
    const DistributionFigures grown = compare(real, scaled);
    EXPECT_NEAR(grown.w1, 0.2, 1e-12);
    EXPECT_NEAR(grown.mean_ratio, 1.2, 1e-12);
}

TEST(StrandFigures, ValuesCountByTheirWeights) {
    std::vector<Weighted> real, same, doubled;
    for (int i = 0; i < 1000; ++i) {
        real.push_back({double(i), 1});
        real.push_back({double(i), 1});
        same.push_back({double(i), 2});
        same.push_back({1e6, 0});
        doubled.push_back({double(i), 0});
        doubled.push_back({2.0 * i, 3});
    }
    // Pairs of equal values against one value of twice the weight: the quantiles differ
    // by at most half the step between neighbours, 0.5 of a mean of 499.5.
    EXPECT_LT(compare(real, same).w1, 0.5 / 499.5);
    EXPECT_NEAR(compare(real, doubled).mean_ratio, 2, 1e-12);
}

TEST(StrandFigures, AreTheSameForAnyThreadCount) {
    const auto truth =
        strands_of(400, 64, [](int i, double t) { return curl(t, 0.1 * i); });
    const auto made = strands_of(
        400, 64, [](int i, double t) { return Vec3(curl(t, 0.2 * i) * (1 + 1e-3 * i)); });
    const std::vector<double> lengths(400, 18.1);
    const StrandFigures all = strand_figures(truth, lengths, made);
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
    const StrandFigures one = strand_figures(truth, lengths, made);
    EXPECT_EQ(all.rms.median, one.rms.median);
    EXPECT_EQ(all.place.p95, one.place.p95);
    EXPECT_EQ(all.curvature.w1, one.curvature.w1);
    EXPECT_EQ(all.torsion.w1, one.torsion.w1);
    EXPECT_EQ(all.torsion.mean_ratio, one.torsion.mean_ratio);
}

TEST(StrandFigures, StrandsThatDoNotMatchAreRefused) {
    const auto a = strands_of(2, 8, [](int, double t) { return Vec3(0, 0, t); });
    const auto b = strands_of(3, 8, [](int, double t) { return Vec3(0, 0, t); });
    const std::vector<double> lengths(2, 1.0);
    EXPECT_THROW(strand_figures(a, lengths, b), std::invalid_argument);
    EXPECT_THROW(strand_figures(b, lengths, b), std::invalid_argument);
    EXPECT_THROW(strand_figures({8, {}}, {}, {8, {}}), std::invalid_argument);
}

}  // namespace
}  // namespace lancret
