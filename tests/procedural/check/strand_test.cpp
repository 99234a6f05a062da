#include "procedural/check/strand.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/procedural/made_guides.h"

namespace lancret {
namespace {

HelixState<float> narrowed(const HelixState<double>& state) {
    return {state.frame.cast<float>(), state.position.cast<float>()};
}

/// An interval of length `ds` that starts at the origin with `frame`.
struct Interval {
    HelixState<double> start, end;

    Interval(const Vec3& u, double ds, const Mat3& frame = Mat3::Identity())
        : start{frame, Vec3::Zero()}, end(start) {
        advance<double>(end, u, ds);
    }
    MeasuredInterval measured() const {
        return measured_interval(narrowed(start), narrowed(end));
    }
};

// Entries of float frames are accurate to 6e-8. Both frames have nine, so the rotation
// vector between them is accurate to about 5e-7, curvatures to that over ds, and the
// length to a quarter of it (its part in sqrt(p^2 + (1 - p^2) sinc^2)) plus the rounding
// of the chord.
constexpr double kTurnError = 1e-6, kLengthError = 5e-7;

TEST(MeasuredInterval, RecoversRandomHelices) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> step(0.05, 1), angle(0.05, 2);
    for (int round = 0; round < 500; ++round) {
        const double ds = step(random);
        Vec3 u(normal(random), normal(random), normal(random));
        u *= angle(random) / ds / u.norm();
        const auto m = Interval(u, ds, test::random_rotation(random)).measured();
        EXPECT_NEAR(m.length, ds, kLengthError * ds);
        EXPECT_NEAR(m.kappa, std::hypot(u.y(), u.z()), kTurnError / ds);
        EXPECT_NEAR(m.tau, u.x(), kTurnError / ds);
        EXPECT_NEAR(m.angle, u.norm() * ds, kTurnError);
    }
}

TEST(MeasuredInterval, OfAStraightIntervalIsItsChord) {
    const auto m =
        Interval(Vec3::Zero(), 0.7, test::random_guides(1, 1, 2).root_frames[0])
            .measured();
    EXPECT_NEAR(m.length, 0.7, kLengthError * 0.7);
    EXPECT_NEAR(m.kappa, 0, kTurnError / 0.7);
}

TEST(MeasuredInterval, OfACircleIsItsArcNotItsChord) {
    // Two radians of a unit circle: arc 2, chord 2 sin 1 = 1.683.
    const auto m = Interval({0, 0, 1}, 2).measured();
    EXPECT_NEAR(m.length, 2, 2 * kLengthError);
    EXPECT_NEAR(m.kappa, 1, kTurnError);
    EXPECT_NEAR(m.tau, 0, kTurnError);
}

TEST(MeasuredInterval, OfPureTwistIsStraight) {
    const auto m = Interval({1.5, 0, 0}, 1).measured();
    EXPECT_NEAR(m.length, 1, kLengthError);
    // 1 - p^2 is the squared error of the axis; the square root recovers the error.
    EXPECT_NEAR(m.kappa, 0, kTurnError);
    EXPECT_NEAR(m.tau, 1.5, kTurnError);
}

TEST(MeasuredInterval, SignsTorsion) {
    EXPECT_NEAR(Interval({-0.8, 0.3, 0.1}, 1).measured().tau, -0.8, kTurnError);
}

TEST(PlaceOn, WalksTheHelix) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal(0, 0.8);
    for (int round = 0; round < 200; ++round) {
        const Vec3 u(normal(random), normal(random), normal(random));
        const Interval interval(u, 0.9, test::random_rotation(random));
        for (const double t : {0.0, 0.25, 0.5, 1.0}) {
            HelixState<double> exact = interval.start;
            advance<double>(exact, u, 0.9 * t);
            const Vec3 place = place_on(narrowed(interval.start), interval.measured(), t);
            EXPECT_LT((place - exact.position).norm(), kTurnError * 0.9);
        }
    }
}

TEST(PlaceOn, ReachesTheEndOfAStraightInterval) {
    const Interval interval(Vec3::Zero(), 0.9);
    EXPECT_LT(
        (place_on(narrowed(interval.start), interval.measured(), 0.5) - Vec3(0.45, 0, 0))
            .norm(),
        kTurnError);
}

TEST(OrthogonalityError, IsThatOfTheWorstFrame) {
    std::vector<HelixState<float>> states(5);
    EXPECT_EQ(orthogonality_error(states), 0);
    states[3].frame(0, 0) = 1.001f;
    // 1.001^2 - 1; the float is within 6e-8 of 1.001.
    EXPECT_NEAR(orthogonality_error(states), 0.002001, 2e-7);
}

TEST(OrthogonalityError, IsNotHiddenByNaN) {
    std::vector<HelixState<float>> states(3);
    states[2].frame(1, 1) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(orthogonality_error(states) <= 1e-6);
}

TEST(OrthogonalityError, OfANaNBeforeGoodFramesStays) {
    std::vector<HelixState<float>> states(3);
    states[0].frame(1, 1) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(orthogonality_error(states) <= 1e-6);
}

/// y = a x^2 for x in [0, n], exact in both bases.
struct Parabola {
    std::vector<Point4f> points, tangents;
    EmittedStrand strand;

    Parabola(CurveBasis basis, float a, int n) {
        if (basis == CurveBasis::hermite) {
            for (int i = 0; i <= n; ++i) {
                points.push_back({float(i), a * float(i * i), 0, 1});
                tangents.push_back({1, 2 * a * float(i), 0, 0});
            }
        } else {
            // (c- + 4 c + c+) / 6 of the control values a (i^2 - 1/3) is a i^2.
            for (int i = -1; i <= n + 1; ++i) {
                points.push_back({float(i), a * (float(i * i) - 1.0f / 3), 0, 1});
            }
        }
        strand = {basis, points, tangents};
    }
    Parabola(const Parabola&) = delete;
};

TEST(EmittedStrand, LengthOfAParabolaIsItsClosedForm) {
    const double a = 0.0625, n = 12, m = 2 * a * n;
    const double exact = (m * std::hypot(1, m) + std::asinh(m)) / (4 * a);
    for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
        const Parabola parabola(basis, float(a), int(n));
        EXPECT_EQ(parabola.strand.segments(), 12u);
        // Quadrature with four points leaves 6e-10 of the eighth derivative, which is
        // below 1e-4; the thirds in the B-spline's control points are rounded by 5e-7
        // each.
        EXPECT_NEAR(parabola.strand.length(), exact, 1e-6);
    }
}

TEST(EmittedStrand, PositionAndDerivativeAreTheParabola) {
    for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
        const Parabola parabola(basis, 0.25f, 6);
        for (int j = 0; j < 6; ++j) {
            for (const double t : {0.0, 0.3, 1.0}) {
                const double x = j + t;
                EXPECT_LT(
                    (parabola.strand.position(j, t) - Vec3(x, 0.25 * x * x, 0)).norm(),
                    1e-6);
                EXPECT_LT((parabola.strand.derivative(j, t) - Vec3(1, 0.5 * x, 0)).norm(),
                          3e-6);
            }
        }
    }
}

}  // namespace
}  // namespace lancret
