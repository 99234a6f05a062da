#include "guides/strand/curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lancret {
namespace {

/// A right-handed helix of radius a and pitch 2 pi b at angle v.
Vec3 helix(double v, double a = 1.0, double b = 0.4) {
    return {a * std::cos(v), a * std::sin(v), b * v};
}

/// n + 1 points of the helix with 0 <= v <= 4 whose spacing varies 5 times: the map's
/// slope is 1 + (2/3) cos, between 1/3 and 5/3.
std::vector<Vec3> uneven_helix(int n) {
    std::vector<Vec3> points;
    for (int i = 0; i <= n; ++i) {
        const double x = double(i) / n;
        points.push_back(helix(4 * (x + std::sin(4 * kPi * x) / (6 * kPi))));
    }
    return points;
}

/// The largest distance of the curve from the helix at the same height.
double helix_error(const Curve& curve) {
    double worst = 0;
    for (int i = 0; i <= 4000; ++i) {
        const Vec3 x = evaluate(curve, curve.knots.back() * i / 4000).position;
        worst = std::max(worst, (x - helix(x.z() / 0.4)).norm());
    }
    return worst;
}

TEST(Curve, PositionConvergesAtOrderFourOnUnevenPoints) {
    double previous = helix_error(*curve_through(uneven_helix(40)));
    for (int n : {80, 160, 320}) {
        const double error = helix_error(*curve_through(uneven_helix(n)));
        const double order = std::log2(previous / error);
        std::printf("n = %d: error %.3g, order %.2f\n", n, error, order);
        EXPECT_NEAR(order, 4.0, 0.3);
        previous = error;
    }
}

TEST(Curve, PassesThroughItsPointsWithTwoContinuousDerivatives) {
    const std::vector<Vec3> points = uneven_helix(23);
    const Curve curve = *curve_through(points);
    ASSERT_EQ(curve.pieces.size(), 23u);
    for (std::size_t k = 1; k < curve.pieces.size(); ++k) {
        const double h = curve.knots[k] - curve.knots[k - 1];
        const auto& c = curve.pieces[k - 1];
        const Vec3 end = c[0] + h * (c[1] + h * (c[2] + h * c[3]));
        const Vec3 slope = c[1] + h * (2 * c[2] + 3 * h * c[3]);
        const CurvePoint next = evaluate(curve, curve.knots[k]);
        // Round-off of a few operations on numbers of size 1, over h >= 0.03 for the
        // slope and h^2 for the second derivative.
        EXPECT_LT((next.position - points[k]).norm(), 1e-15);
        EXPECT_LT((end - points[k]).norm(), 1e-14);
        EXPECT_LT((slope - next.d1).norm(), 1e-13);
        EXPECT_LT((2 * c[2] + 6 * h * c[3] - next.d2).norm(), 1e-12);
    }
}

TEST(Curve, FourPointsGiveTheirCubicAndThreeTheirParabola) {
    // Not-a-knot on four points leaves no free joint: there is one third derivative.
    const std::vector<Vec3> four{{0, 0, 0}, {1, 0.5, 0}, {1.5, 2, 0.3}, {3, 2, 1}};
    const Curve cubic = *curve_through(four);
    EXPECT_LT((cubic.pieces[0][3] - cubic.pieces[1][3]).norm(), 1e-14);
    EXPECT_LT((cubic.pieces[2][3] - cubic.pieces[1][3]).norm(), 1e-14);
    const Curve parabola = *curve_through(std::span(four).first(3));
    EXPECT_LT(parabola.pieces[0][3].norm() + parabola.pieces[1][3].norm(), 1e-14);
    EXPECT_LT((parabola.pieces[0][2] - parabola.pieces[1][2]).norm(), 1e-14);
}

TEST(Curve, DerivativesMatchFiniteDifferences) {
    const Curve curve = *curve_through(uneven_helix(9));
    const double t = 0.43 * curve.knots.back(), h = 1e-4;
    const CurvePoint a = evaluate(curve, t - h), b = evaluate(curve, t),
                     c = evaluate(curve, t + h);
    // Central differences of a cubic: exact for d2 and d3, h^2/6 |d3| for d1.
    EXPECT_LT(((c.position - a.position) / (2 * h) - b.d1).norm(),
              h * h / 6 * b.d3.norm() + 1e-11);
    EXPECT_LT(((c.d1 - a.d1) / (2 * h) - b.d2).norm(), 1e-10);
    EXPECT_LT(((c.d2 - a.d2) / (2 * h) - b.d3).norm(), 1e-10);
}

TEST(Curve, PointsOnALineGiveTheLine) {
    const Vec3 from(1, -2, 3), along = Vec3(2, 3, 6) / 7;
    std::vector<Vec3> points;
    for (double s : {0.0, 0.3, 0.5, 1.5, 1.7, 4.0}) points.push_back(from + s * along);
    for (std::size_t n : {2, 3, 4, 6}) {
        const Curve curve = *curve_through(std::span(points).first(n));
        const SampledCurve line = resample(curve, 10);
        const double length = (points[n - 1] - from).norm();
        EXPECT_NEAR(line.length, length, 1e-14);
        for (int i = 0; i <= 10; ++i) {
            EXPECT_LT((line.positions[i] - from - length * i / 10 * along).norm(), 1e-14);
            EXPECT_LT((line.tangents[i] - along).norm(), 1e-14);
        }
    }
}

TEST(Curve, RepeatedPointsChangeNothing) {
    const std::vector<Vec3> points = uneven_helix(12);
    std::vector<Vec3> repeated;
    for (std::size_t i = 0; i < points.size(); ++i) {
        repeated.insert(repeated.end(), 1 + i % 3, points[i]);
    }
    repeated.push_back(points.back());
    const Curve a = *curve_through(points), b = *curve_through(repeated);
    EXPECT_EQ(a.knots, b.knots);
    EXPECT_EQ(a.arc, b.arc);
}

TEST(Curve, EndsOnTheLastPointEvenIfItNearlyRepeats) {
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {2, 1, 1e-9}};
    const Curve curve = *curve_through(points);
    EXPECT_EQ(curve.pieces.size(), 2u);
    EXPECT_LT((evaluate(curve, curve.knots.back()).position - points.back()).norm(),
              1e-15);
}

TEST(Curve, LengthsThatOverflowGiveNullopt) {
    EXPECT_FALSE(
        curve_through(std::vector<Vec3>{{0, 0, 0}, {1e200, 0, 0}, {0, 1e200, 0}}));
    EXPECT_FALSE(bspline_curve(
        std::vector<Vec3>{{0, 0, 0}, {1e200, 0, 0}, {0, 1e200, 0}, {0, 1e200, 1}}));
    EXPECT_TRUE(
        curve_through(std::vector<Vec3f>{{0, 0, 0}, {1e38f, 0, 0}, {0, 3e38f, 0}}));
}

TEST(Curve, PointsWithoutACurveGiveNullopt) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(curve_through(std::vector<Vec3>{}));
    EXPECT_FALSE(curve_through(std::vector<Vec3>{{1, 2, 3}}));
    EXPECT_FALSE(curve_through(std::vector<Vec3>(5, Vec3(1, 2, 3))));
    EXPECT_FALSE(curve_through(std::vector<Vec3>{{0, 0, 0}, {nan, 0, 0}}));
    EXPECT_FALSE(bspline_curve(std::vector<Vec3>(5, Vec3(1, 2, 3))));
    EXPECT_FALSE(bspline_curve(uneven_helix(2)));
}

TEST(Curve, HairpinHasFiniteSamplesInOrder) {
    // Out and back along one line: the speed is zero at the turn.
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0, 0, 0}};
    const SampledCurve samples = resample(*curve_through(points), 40);
    for (int i = 0; i < 40; ++i) {
        EXPECT_GT(samples.parameters[i + 1], samples.parameters[i]);
        EXPECT_NEAR(samples.tangents[i].norm(), 1, 1e-14);
        EXPECT_LE((samples.positions[i + 1] - samples.positions[i]).norm(),
                  samples.step() * (1 + 1e-9));
    }
}

TEST(Curve, ArcLengthOfAParabolaIsItsClosedForm) {
    // Control points of y = x^2 on 0 <= x <= 1, as a B-spline of one piece: with x(t) =
    // t, y = t^2 the control points are (i - 1, (i - 1)^2 - 1/3).
    std::vector<Vec3> control;
    for (int i = 0; i < 4; ++i) {
        control.push_back({i - 1.0, (i - 1.0) * (i - 1.0) - 1 / 3.0, 0});
    }
    const Curve curve = *bspline_curve(control);
    EXPECT_LT(evaluate(curve, 0).position.norm(), 1e-15);
    for (double x : {0.1, 0.5, 0.9, 1.0}) {
        const double closed = x * std::sqrt(1 + 4 * x * x) / 2 + std::asinh(2 * x) / 4;
        // Halving ends at a change of 1e-10; the remaining error is 1/63 of it.
        EXPECT_NEAR(arc_length(curve, x), closed, 2e-12 * closed);
        EXPECT_NEAR(parameter_at(curve, closed), x, 3e-12);
    }
}

TEST(Curve, ArcLengthOfACircleConvergesAtOrderFour) {
    // With fewer points the next term of the error, from the ends, is as large as the
    // first and the measured order wanders (3.9 and 3.0 at n = 32 and 64). The error
    // of quadrature is at most 1e-11 of the length.
    double previous = 0;
    for (int n : {64, 128, 256}) {
        std::vector<Vec3> points;
        for (int i = 0; i <= n; ++i) {
            points.push_back({std::cos(5.0 * i / n), std::sin(5.0 * i / n), 0});
        }
        const double error = std::abs(curve_through(points)->length() - 5);
        if (previous > 0) {
            const double order = std::log2(previous / error);
            std::printf("n = %d: error %.3g, order %.2f\n", n, error, order);
            EXPECT_NEAR(order, 4.0, 0.4);
        }
        previous = error;
    }
}

TEST(Curve, SamplesAreEquallySpacedInArcLength) {
    const Curve curve = *curve_through(uneven_helix(30));
    const SampledCurve samples = resample(curve, 100);
    EXPECT_EQ(samples.length, curve.length());
    EXPECT_EQ(samples.positions.size(), 101u);
    for (int i = 0; i <= 100; ++i) {
        EXPECT_NEAR(arc_length(curve, samples.parameters[i]), curve.length() * i / 100,
                    1e-11 * curve.length());
        EXPECT_NEAR(samples.tangents[i].norm(), 1, 1e-15);
    }
    EXPECT_THROW(resample(curve, 0), std::invalid_argument);
}

TEST(Curve, BSplineStartsAtItsPlainEnd) {
    const std::vector<Vec3> p = uneven_helix(6);
    const Curve curve = *bspline_curve(p);
    ASSERT_EQ(curve.pieces.size(), p.size() - 3);
    EXPECT_LT((evaluate(curve, 0).position - (p[0] + 4 * p[1] + p[2]) / 6).norm(), 1e-15);
    EXPECT_LT(
        (evaluate(curve, curve.knots.back()).position - (p[4] + 4 * p[5] + p[6]) / 6)
            .norm(),
        1e-14);
    for (std::size_t k = 1; k < curve.pieces.size(); ++k) {
        // One unit before the knot the second derivative is c2, and d3 is constant.
        const Vec3 before = 2 * curve.pieces[k - 1][2] + 6 * curve.pieces[k - 1][3];
        EXPECT_LT((before - 2 * curve.pieces[k][2]).norm(), 1e-14);
    }
}

TEST(Curve, StrandCurveFollowsTheBasis) {
    Strands strands;
    for (const Vec3& p : uneven_helix(6)) strands.points.push_back(p.cast<float>());
    strands.first = {0, 7};
    EXPECT_EQ(strand_curve(strands, 0)->pieces.size(), 6u);
    strands.basis = Basis::bspline;
    EXPECT_EQ(strand_curve(strands, 0)->pieces.size(), 4u);
}

}  // namespace
}  // namespace lancret
