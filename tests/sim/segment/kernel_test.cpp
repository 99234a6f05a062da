#include "sim/segment/kernel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "guides/helix/helix.h"
#include "sim/segment/gauss_legendre.h"
#include "sim/segment/second_derivative.h"

namespace lancret {
namespace {

const double kTurns[] = {0, 1e-9, 1e-3, 0.1, 0.99, 1.01, 3, 10, 40};
const Vec3 kDirection = Vec3(0.48, -0.6, 0.64);
constexpr double kLength = 1.7;

SegmentPoint<double> point(const Vec3& k, double u) {
    return segment_point<double>(k.data(), u, stumpff_halvings(u * u * k.squaredNorm()));
}

/// c_m(x) in long double: by the series for small x, otherwise from the trigonometric
/// functions by c_m = (1 / (m - 2)! - c_{m-2}) / x.
long double stumpff_reference(int m, long double x) {
    long double factorial = 1;
    for (int i = 2; i <= m; ++i) factorial *= i;
    if (x < 8) {
        long double term = 1 / factorial, sum = 0;
        for (int n = 1; n < 60; ++n) {
            sum += term;
            term *= -x / ((2 * n + m - 1) * (2 * n + m));
        }
        return sum;
    }
    if (m == 0) return std::cos(std::sqrt(x));
    if (m == 1) return std::sin(std::sqrt(x)) / std::sqrt(x);
    return (factorial > 1 ? m * (m - 1) / factorial - stumpff_reference(m - 2, x)
                          : 1 - stumpff_reference(m - 2, x)) /
           x;
}

TEST(Stumpff, FunctionsAreTheClosedFormsInLongDouble) {
    for (const double x : {0.3, 0.99, 1.01, 7.0, 60.0, 900.0}) {
        StumpffTail<double> tail;
        const Stumpff<double> c = stumpff_functions(x, stumpff_halvings(x), tail);
        const double got[] = {0, c.c1, c.c2, c.c3, c.c4, c.c5, tail.c6, tail.c7};
        // Each doubling may double the error of a value; values are at most 1 / m!.
        const double rounding = 4e-16 * std::pow(2, stumpff_halvings(x));
        double factorial = 1;
        for (int m = 1; m < 8; ++m) {
            factorial *= m;
            EXPECT_NEAR(got[m], double(stumpff_reference(m, x)), rounding / factorial)
                << m << " " << x;
        }
    }
}

TEST(SegmentKernel, PositionIsTheHelixStep) {
    for (const double turn : kTurns) {
        const Vec3 k = kDirection * turn / kLength;
        const Vec3 want = helix_step<double>(k, kLength).displacement;
        const SegmentPoint<double> got = point(k, kLength);
        EXPECT_LT((Vec3::Map(got.p) - want).norm(), 1e-14 * kLength) << turn;
    }
}

TEST(SegmentKernel, JacobianIsTheStepsDerivative) {
    for (const double turn : kTurns) {
        const Vec3 k = kDirection * turn / kLength;
        const Mat3 want = helix_step_derivative(k, kLength).position;
        const SegmentPoint<double> got = point(k, kLength);
        const Mat3 j =
            Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&got.j[0][0]);
        EXPECT_LT((j - want).norm(), 2e-14 * kLength * kLength) << turn;
    }
}

// Central differences with step h of a function of size s have errors of h^2 s (from the
// third derivative) and eps s / h: at h = 1e-5 both are about 1e-10 s.
constexpr double kStep = 1e-5, kDifference = 1e-9;

TEST(SegmentKernel, SecondDerivativesAreDifferencesOfTheFirst) {
    const Vec3 a(0.3, -0.2, 0.9), b(-0.5, 0.7, 0.4);
    for (const double turn : kTurns) {
        const Vec3 k = kDirection * turn / kLength;
        const SegmentSecondDerivative second(k, kLength);
        const auto up = helix_step_derivative(k + kStep * a, kLength);
        const auto down = helix_step_derivative(k - kStep * a, kLength);
        const Vec3 position = (up.position - down.position) * b / (2 * kStep);
        const Vec3 angular = (up.angular - down.angular) * b / (2 * kStep);
        const double size = std::pow(kLength, 3);
        EXPECT_LT((second.position(a, b) - position).norm(), kDifference * size) << turn;
        EXPECT_LT((second.angular(a, b) - angular).norm(), kDifference * size) << turn;
        EXPECT_LT((second.position(a, b) - second.position(b, a)).norm(), 1e-14 * size);
    }
}

TEST(SegmentKernel, RotationsCommuteOnlyUpToTheirCrossProduct) {
    // Second derivatives of a frame are symmetric, so DV[a] b - DV[b] a = V a x V b, with
    // V in the start frame.
    const Vec3 a(0.3, -0.2, 0.9), b(-0.5, 0.7, 0.4);
    for (const double turn : kTurns) {
        const Vec3 k = kDirection * turn / kLength;
        const SegmentSecondDerivative second(k, kLength);
        const Mat3 v = helix_step_derivative(k, kLength).angular;
        const Vec3 want = (v * a).cross(v * b);
        const Vec3 got = second.angular(a, b) - second.angular(b, a);
        EXPECT_LT((got - want).norm(), 1e-13 * std::max(1., turn)) << turn;
    }
}

TEST(GaussLegendre, IsExactToItsDegree) {
    for (int n = 1; n <= kMaxGaussPoints; ++n) {
        const GaussRule rule = gauss_rule(n);
        for (int degree = 0; degree < 2 * n; ++degree) {
            double sum = 0;
            for (int i = 0; i < n; ++i) {
                sum += rule.weights[i] * std::pow(rule.nodes[i], degree);
            }
            EXPECT_NEAR(sum * (degree + 1), 1, 1e-13) << n << " " << degree;
        }
    }
}

TEST(GaussLegendre, PointsAreMultiplesOfFour) {
    EXPECT_EQ(gauss_points(0), 8);
    EXPECT_EQ(gauss_points(3.01), 12);
    EXPECT_EQ(gauss_points(1e300), kMaxGaussPoints);
}

}  // namespace
}  // namespace lancret
