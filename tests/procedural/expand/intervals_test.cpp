#include "procedural/expand/intervals.h"

#include <gtest/gtest.h>

#include "procedural/check/strand.h"
#include "procedural/curves/emitted_curve.h"
#include "tests/procedural/made_hair.h"

namespace lancret {
namespace {

using test::MadeHair;

/// The largest distance of the emitted curve from the strand, cm, by brute force: from
/// many places of the curve to a fine polyline along the strand.
double brute_distance(std::span<const HelixState<float>> states, double ds,
                      CurveBasis basis) {
    constexpr int kFine = 32;
    const int n = int(states.size()) - 1;
    StrandBuffer curve;
    emit({.states = states, .ds = float(ds)}, basis, curve);
    std::vector<Vec3> strand;
    for (int j = 0; j < n; ++j) {
        const MeasuredInterval m = measured_interval(states[j], states[j + 1]);
        for (int q = 0; q <= kFine; ++q) {
            strand.push_back(place_on(states[j], m, double(q) / kFine));
        }
    }
    const EmittedStrand emitted{basis, curve.points, curve.tangents};
    double worst = 0;
    for (int j = 0; j < n; ++j) {
        for (int q = 0; q <= 8; ++q) {
            const Vec3 p = emitted.position(j, q / 8.0);
            double nearest = 1e9;
            for (std::size_t i = 0; i + 1 < strand.size(); ++i) {
                const Vec3 along = strand[i + 1] - strand[i], off = p - strand[i];
                const double square = along.squaredNorm();
                const double t =
                    square > 0 ? std::clamp(off.dot(along) / square, 0.0, 1.0) : 0;
                nearest = std::min(nearest, (off - t * along).norm());
            }
            worst = std::max(worst, nearest);
        }
    }
    return worst;
}

TEST(EmissionDistance, IsTheBruteForceDistanceUpToItsSampling) {
    const int n = 12;
    const MadeHair hair(20, n, 1, 4, 4, 0.3);
    std::vector<HelixState<float>> states(n + 1);
    for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
        for (std::size_t i = 0; i < 20; ++i) {
            synthesize_child<float>(hair.binding, hair.profiles, Blend::option1, i,
                                    states);
            const float ds = hair.binding.lengths[i] / float(n);
            const double found = emission_distance(states, ds, basis);
            const double brute = brute_distance(states, ds, basis);
            // On a smooth strand the distance within an interval goes as t^2 (1 - t)^2:
            // at 1/4 it is 0.56 of its maximum.
            EXPECT_GE(found, 0.5 * brute) << i;
            // The distance across the strand at equal parameter exceeds that of the
            // nearest place by curvature only, kappa d / 2 of it, and by the sag of the
            // polyline.
            EXPECT_LE(found, 1.3 * brute + 1e-4) << i;
        }
    }
}

TEST(EmissionDistance, OfACircleIsItsClosedForm) {
    // t^2 (1 - t)^2 theta^4 R / 24 in the middle, where it is largest.
    const double radius = 4, theta = 0.5, ds = radius * theta;
    std::vector<HelixState<float>> states(13);
    for (int i = 0; i <= 12; ++i) {
        HelixState<double> state;
        advance<double>(state, {0, 0, 1 / radius}, i * ds);
        states[i] = {state.frame.cast<float>(), state.position.cast<float>()};
    }
    const double exact = std::pow(theta, 4) * radius / 384;
    const double found = emission_distance(states, float(ds), CurveBasis::hermite);
    EXPECT_GT(found, 0.5 * exact);
    EXPECT_LT(found, 1.1 * exact);
}

TEST(EmissionDistance, OfAStraightStrandIsRoundOff) {
    std::vector<HelixState<float>> states(9);
    for (int i = 0; i <= 8; ++i) states[i].position = Vec3f(0.5f * float(i), 0, 0);
    for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
        EXPECT_LT(emission_distance(states, 0.5f, basis), 1e-6);
    }
}

/// The largest emission_distance of the children, cm.
double farthest(const MadeHair& hair, int intervals, CurveBasis basis) {
    const auto profiles = guide_profiles<float>(hair.standing.guides, intervals);
    std::vector<HelixState<float>> states(intervals + 1);
    double worst = 0;
    for (std::size_t i = 0; i < hair.binding.size(); ++i) {
        synthesize_child<float>(hair.binding, profiles, Blend::option1, i, states);
        worst = std::max(
            worst,
            emission_distance(states, hair.binding.lengths[i] / float(intervals), basis));
    }
    return worst;
}

TEST(IntervalsWithin, KeepTheToleranceWithoutWaste) {
    const MadeHair hair(200, 8, 2, 4, 4, 0.15);
    const Guides& guides = hair.standing.guides;
    for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
        for (const double tolerance : {0.1, 0.03, 0.01}) {
            const int n =
                intervals_within(hair.binding, guides, Blend::option1, tolerance, basis)
                    .count;
            EXPECT_EQ(n % guides.segments, 0);
            EXPECT_LE(farthest(hair, n, basis), tolerance);
            if (n > 2 * guides.segments) {
                // One interval per segment less exceeds what the sample may use.
                EXPECT_GT(farthest(hair, n - guides.segments, basis), 0.5 * tolerance);
            }
        }
    }
}

TEST(IntervalsWithin, GrowAsTheToleranceShrinks) {
    const MadeHair hair(100, 8, 3, 4, 4, 0.15);
    int before = 0;
    for (const double tolerance : {1.0, 0.1, 0.01, 0.001}) {
        const int n = intervals_within(hair.binding, hair.standing.guides, Blend::option1,
                                       tolerance, CurveBasis::bspline)
                          .count;
        EXPECT_GE(n, before);
        before = n;
    }
    EXPECT_GT(before, 8);
}

TEST(IntervalsWithin, StopAtTheMaximum) {
    const MadeHair hair(50, 8, 4);
    const FoundIntervals found =
        intervals_within(hair.binding, hair.standing.guides, Blend::option1, 1e-9,
                         CurveBasis::bspline, 24);
    EXPECT_EQ(found.count, 24);
    EXPECT_EQ(found.distance, farthest(hair, 24, CurveBasis::bspline));
}

TEST(IntervalsWithin, NoIntervalTurnsByMoreThanTwoRadians) {
    Guides guides;
    test::add_guide(guides, {Vec3(0, 0, 1), Vec3(0, 0, 0.1)}, 10);  // 5 radians, then 0.5
    const std::vector<Vec3f> normals = {Vec3f::UnitZ()};
    const Binding binding = bind(test::plane_roots(5, 5), guides, normals, {});
    EXPECT_EQ(
        intervals_within(binding, guides, Blend::option1, 100, CurveBasis::bspline).count,
        6);
}

}  // namespace
}  // namespace lancret
