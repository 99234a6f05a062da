#include "guides/helix/helix.h"

#include <gtest/gtest.h>

#include <random>
#include <unsupported/Eigen/MatrixFunctions>

namespace lancret {
namespace {

/// Frame and position after a step, computed independently by the exponential of the 4x4
/// matrix [hat(u) e0; 0 0] ds: (R, r)' = (R, r) times that matrix.
Eigen::Matrix4d motion(const Vec3& u, double ds) {
    Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
    m.topLeftCorner<3, 3>() = hat<double>(u) * ds;
    m(0, 3) = ds;
    return m.exp();
}

double orthogonality_error(const Mat3& r) {
    return (r.transpose() * r - Mat3::Identity()).cwiseAbs().maxCoeff();
}

TEST(Helix, StepIsTheMatrixExponential) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 2000; ++i) {
        // Turns per step from 1e-9 to 10 radians: both sides of the switch from series to
        // closed form.
        const double turn = std::pow(10.0, -9 + 10.0 * i / 2000);
        const Vec3 u =
            turn * Vec3(normal(random), normal(random), normal(random)).normalized();
        const HelixStep<double> step = helix_step<double>(u, 1.0);
        const Eigen::Matrix4d exact = motion(u, 1.0);
        // Pade with squaring loses a digit for large turns; 1e-14 is required up to pi.
        const double tolerance = turn < 3.2 ? 1e-14 : 5e-14;
        EXPECT_LT((step.rotation - exact.topLeftCorner<3, 3>()).cwiseAbs().maxCoeff(),
                  tolerance);
        EXPECT_LT(
            (step.displacement - exact.topRightCorner<3, 1>()).cwiseAbs().maxCoeff(),
            tolerance);
    }
}

TEST(Helix, StraightStepMovesAlongTheTangent) {
    const HelixStep<double> step = helix_step<double>(Vec3::Zero(), 2.5);
    EXPECT_EQ(step.rotation, Mat3::Identity());
    EXPECT_EQ(step.displacement, Vec3(2.5, 0, 0));
}

TEST(Helix, PureTwistIsStraightAndTurnsTheNormals) {
    const HelixStep<double> step = helix_step<double>(Vec3(0.7, 0, 0), 2.0);
    EXPECT_LT((step.displacement - Vec3(2, 0, 0)).norm(), 1e-15);
    EXPECT_NEAR(step.rotation(1, 1), std::cos(1.4), 1e-15);
    EXPECT_NEAR(step.rotation(2, 1), std::sin(1.4), 1e-15);
}

TEST(Helix, PlanarStepIsACircularArc) {
    // k2 only bends the tangent towards n1: a circle of radius 1/k2.
    const double k = 0.5, s = 3;
    const HelixStep<double> step = helix_step<double>(Vec3(0, 0, k), s);
    EXPECT_NEAR(step.displacement.x(), std::sin(k * s) / k, 1e-15);
    EXPECT_NEAR(step.displacement.y(), (1 - std::cos(k * s)) / k, 1e-15);
    EXPECT_EQ(step.displacement.z(), 0);
}

TEST(Helix, PositiveTwistWithBendingIsARightHandedHelix) {
    // u = (tau, 0, kappa) has axis tau n0 + kappa n2; the motion along the axis is
    // positive.
    HelixState<double> state;
    const Vec3 u(1, 0, 2);
    advance<double>(state, u, 10);
    const double w = u.norm(), pitch_speed = u.x() / w;
    EXPECT_NEAR(state.position.dot(u.normalized()), pitch_speed * 10, 1e-14);
}

TEST(Helix, DerivativeMatchesFiniteDifferences) {
    std::mt19937 random(2);
    std::normal_distribution<double> normal;
    for (double size : {0.0, 1e-6, 1e-2, 0.4, 0.999, 1.001, 2.0, 7.0}) {
        Vec3 u(normal(random), normal(random), normal(random));
        u *= size / u.norm();
        const double ds = 0.8, h = 1e-5;
        const HelixStepDerivative d = helix_step_derivative(u / ds, ds);
        const Mat3 rotation = helix_step<double>(u / ds, ds).rotation;
        for (int i = 0; i < 3; ++i) {
            const HelixStep<double> up =
                helix_step<double>(u / ds + h * Vec3::Unit(i), ds);
            const HelixStep<double> down =
                helix_step<double>(u / ds - h * Vec3::Unit(i), ds);
            // Central differences: an error of h^2 / 6 times a third derivative of order
            // ds^4.
            const Vec3 moved = (up.displacement - down.displacement) / (2 * h);
            EXPECT_LT((moved - d.position.col(i)).norm(), 1e-10) << size;
            const Mat3 spin =
                (up.rotation - down.rotation) / (2 * h) * rotation.transpose();
            EXPECT_LT((spin - hat<double>(d.angular.col(i))).norm(), 1e-10) << size;
        }
    }
}

TEST(Helix, HundredThousandStepsStayOrthogonalAndKeepLength) {
    const int steps = 100000;
    const double ds = 0.05;
    HelixState<double> raw, clean;
    long double length = 0;  // a sum of 10^5 terms in double alone loses 2e-12
    double worst_clean = 0, worst_raw = 0;
    for (int i = 0; i < steps; ++i) {
        const Vec3 u(std::sin(0.01 * i), 2 * std::cos(0.003 * i), 1.5);
        advance<double>(raw, u, ds);
        const Vec3 before = clean.position;
        const Mat3 start = clean.frame;
        advance<double>(clean, u, ds);
        orthonormalize<double>(clean.frame);
        // The arc length of the step: its chord, times the ratio of arc to chord of this
        // helix by the matrix exponential.
        length += (start.transpose() * (clean.position - before)).norm() /
                  (motion(u, ds).topRightCorner<3, 1>().norm() / ds);
        worst_raw = std::max(worst_raw, orthogonality_error(raw.frame));
        worst_clean = std::max(worst_clean, orthogonality_error(clean.frame));
    }
    EXPECT_LT(worst_raw, 2e-11);
    EXPECT_LE(worst_clean, 1e-15);
    EXPECT_LT(std::abs(double(length / (steps * ds)) - 1), 1e-12);
}

TEST(Helix, FloatFramesHoldAtAnyNumberOfSteps) {
    HelixState<float> state;
    float worst = 0;
    for (int i = 0; i < 1000000; ++i) {
        const Vec3f u(std::sin(0.01f * i), 2 * std::cos(0.003f * i), 1.5f);
        advance<float>(state, u, 0.05f);
        orthonormalize<float>(state.frame);
        worst =
            std::max(worst, (state.frame.transpose() * state.frame - Mat3f::Identity())
                                .cwiseAbs()
                                .maxCoeff());
    }
    EXPECT_LT(worst, 1e-6f);
}

TEST(Helix, RotationLogInvertsTheStep) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (double size : {0.0, 1e-12, 1e-4, 1.0, 3.1, 3.14159}) {
        Vec3 w(normal(random), normal(random), normal(random));
        w *= size / w.norm();
        const Mat3 rotation = helix_step<double>(w, 1).rotation;
        EXPECT_LT((rotation_log<double>(rotation) - w).norm(), 1e-14 * (1 + 10 * size));
    }
}

TEST(Helix, SmallestRotationTurnsOneVectorToTheOther) {
    std::mt19937 random(4);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 100; ++i) {
        const Vec3 a = Vec3(normal(random), normal(random), normal(random)).normalized();
        const Vec3 b =
            i == 0 ? Vec3(-a)
                   : Vec3(normal(random), normal(random), normal(random)).normalized();
        const Mat3 r = smallest_rotation<double>(a, b);
        EXPECT_LT((r * a - b).norm(), 1e-12);
        EXPECT_LT(orthogonality_error(r), 1e-12);
        EXPECT_NEAR(r.determinant(), 1, 1e-12);
        // It is smallest if its angle is that between the two vectors.
        EXPECT_NEAR((r.trace() - 1) / 2, a.dot(b), 1e-12);
    }
}

}  // namespace
}  // namespace lancret
