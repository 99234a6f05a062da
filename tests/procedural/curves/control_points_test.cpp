#include "procedural/curves/control_points.h"

#include <gtest/gtest.h>

#include "tests/procedural/curves/emitted.h"
#include "tests/procedural/expand/cubic_error.h"

namespace lancret {
namespace {

using test::Emitted;
using test::helix_position;
using test::helix_states;

TEST(ControlPoints, AStraightStrandIsReproduced) {
    const int n = 9;
    const auto states = helix_states(Vec3::Zero(), 0.5, n);
    for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
        const Emitted emitted(states, 0.5, basis, Vec3f(1, 2, 3));
        for (int j = 0; j < n; ++j) {
            for (const double t : {0.0, 0.4, 1.0}) {
                // Numbers below 8 are rounded by at most 2.4e-7.
                EXPECT_LT((emitted.strand.position(j, t) - Vec3(1 + 0.5 * (j + t), 2, 3))
                              .norm(),
                          5e-7);
            }
        }
        EXPECT_NEAR(emitted.strand.length(), 4.5, 1e-6);
    }
}

TEST(ControlPoints, TheQuasiInterpolantReproducesCubicsInside) {
    // On a cubic the second differences are p'' and 4 p'': (4 - 10) / 36 of p'' is -1/6
    // of it, so that (c- + 4 c + c+) / 6 is the place itself. Inside, frames are not
    // used.
    const auto cubic = [](double x) {
        return Vec3(x, 0.3 * x * x - x, 0.05 * x * x * x - 0.2 * x * x);
    };
    const int n = 10;
    std::vector<HelixState<float>> states(n + 1);
    for (int i = 0; i <= n; ++i) states[i].position = cubic(i).cast<float>();
    const Emitted emitted(states, 1, CurveBasis::bspline);
    // The control points 2 to n - 2 do not depend on places beyond the ends, and segments
    // from 3 to n - 3 depend on these only.
    for (int j = 3; j < n - 3; ++j) {
        for (const double t : {0.0, 0.2, 0.5, 0.9}) {
            // Places below 32 cm are rounded by 1e-6, and the taps add up to 76/36 of
            // that.
            EXPECT_LT((emitted.strand.position(j, t) - cubic(j + t)).norm(), 4e-6);
        }
    }
}

TEST(ControlPoints, ACircleHasTheRadiusOfTheTaps) {
    // On a circle the taps scale by L = 1 + x/6 + x^2/36, x = 2 - 2 cos(theta). The
    // radius of the curve is L (1 - x/6) = 1 - x^3/216 at places and L (23 cos(theta/2) +
    // cos(3 theta/2)) / 24 in the middle of intervals.
    const int n = 12;
    for (const double theta : {0.1, 0.5, 1.0, 1.5}) {
        const double radius = 2, ds = radius * theta;
        const Emitted emitted(helix_states({0, 0, 1 / radius}, ds, n), ds,
                              CurveBasis::bspline);
        const double x = 2 - 2 * std::cos(theta), scale = 1 + x / 6 + x * x / 36;
        const double half =
            scale * (23 * std::cos(theta / 2) + std::cos(1.5 * theta)) / 24;
        const Vec3 centre(0, radius, 0);
        for (int j = 1; j < n - 1; ++j) {
            // Places and control points up to 4 cm in floats: a few roundings of 2.4e-7.
            EXPECT_NEAR((emitted.strand.position(j, 0) - centre).norm(),
                        radius * (1 - x * x * x / 216), 2e-6);
            EXPECT_NEAR((emitted.strand.position(j, 0.5) - centre).norm(), radius * half,
                        2e-6);
        }
    }
}

/// The largest distance at equal arc length between a helix of 12 cm and its curve.
double largest_error(const Vec3& u, int n, CurveBasis basis) {
    const double ds = 12.0 / n;
    const Emitted emitted(helix_states(u, ds, n), ds, basis);
    double worst = 0;
    for (int j = 0; j < n; ++j) {
        for (int q = 0; q <= 8; ++q) {
            const double t = q / 8.0;
            worst = std::max(
                worst,
                (emitted.strand.position(j, t) - helix_position(u, (j + t) * ds)).norm());
        }
    }
    return worst;
}

TEST(ControlPoints, DeviateFromAHelixByTheClosedForm) {
    const Vec3 u(0.6, 0.4, 0.9);
    for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
        for (const int n : {8, 12, 16, 24, 32}) {
            // Places below 12 cm, of three or four control points: 5e-7 each.
            const double exact = test::cubic_error(u, 12.0 / n, basis);
            EXPECT_NEAR(largest_error(u, n, basis), exact, 0.001 * exact + 3e-6) << n;
        }
        // Order 4: half the step gives at most a sixteenth of the error.
        EXPECT_GT(largest_error(u, 12, basis) / largest_error(u, 24, basis), 15);
    }
}

TEST(ControlPoints, BeginAndEndWhereTheStrandDoes) {
    const Vec3 u(0.3, -0.8, 0.5);
    for (const int n : {1, 2, 3, 20}) {
        const double ds = 6.0 / n;
        const Vec3f root(1, 2, 3);
        for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
            const Emitted emitted(helix_states(u, ds, n), ds, basis, root);
            const Vec3 base = root.cast<double>();
            // Outer control points lie up to 6 cm away and are rounded by 5e-7.
            EXPECT_LT((emitted.strand.position(0, 0) - base).norm(), 2e-6) << n;
            EXPECT_LT(
                (emitted.strand.position(n - 1, 1) - base - helix_position(u, 6)).norm(),
                2e-6)
                << n;
        }
    }
}

TEST(ControlPoints, HermitePassesThroughPlacesAlongTheirTangents) {
    const Vec3 u(0.3, -0.8, 0.5);
    const double ds = 0.5;
    const auto states = helix_states(u, ds, 8);
    const Emitted emitted(states, ds, CurveBasis::hermite);
    for (int j = 0; j < 8; ++j) {
        const Vec3 tangent = states[j].frame.col(0).cast<double>();
        EXPECT_LT(
            (emitted.strand.position(j, 0) - states[j].position.cast<double>()).norm(),
            1e-12);
        EXPECT_LT((emitted.strand.derivative(j, 0) - ds * tangent).norm(), 1e-7);
    }
}

/// The face at the start or in the middle of an interval, by the B-spline of normals.
Vec3f face_at(std::span<const Point4f> normals, std::size_t interval, bool middle) {
    const Point4f* n = normals.data() + interval;
    const Vec3f sum =
        middle ? Vec3f(n[0].xyz() + 23 * n[1].xyz() + 23 * n[2].xyz() + n[3].xyz())
               : Vec3f(n[0].xyz() + 4 * n[1].xyz() + n[2].xyz());
    return sum.normalized();
}

TEST(RibbonNormals, AStrandBendsOverItsFace) {
    // A circle in the plane of n0 and a direction at the angle 0.7 from n1 to n2: the
    // face is the normal of the circle at every place. The control point beyond an end is
    // short by turn^2 along the normal there, which counts by 1 / 48 in the middle of the
    // interval and is seen at half the turn: turn^3 / 96 = 3.5e-5 for 0.15.
    const float angle = 0.7f;
    const Vec3 bend = std::cos(angle) * Vec3::UnitY() + std::sin(angle) * Vec3::UnitZ();
    const Vec3 u = 0.3 * Vec3::UnitX().cross(bend);
    const auto states = helix_states(u, 0.5, 10);
    std::vector<Point4f> normals(13);
    ribbon_normals(states, bent_face(states), normals);
    for (std::size_t j = 0; j < 10; ++j) {
        for (const bool middle : {false, true}) {
            const double turned = 0.15 * (double(j) + (middle ? 0.5 : 0));
            const Vec3 face = std::cos(turned) * bend - std::sin(turned) * Vec3::UnitX();
            EXPECT_LT((face_at(normals, j, middle) - face.cast<float>()).norm(), 4e-5f)
                << j;
        }
    }
}

TEST(RibbonNormals, AStraightStrandFacesAlongItsFrameAndTurnsWithIt) {
    // Pure twist: the face is n1, which turns about the tangent by 0.2 per interval.
    const auto states = helix_states(Vec3(0.4, 0, 0), 0.5, 8);
    std::vector<Point4f> normals(11);
    ribbon_normals(states, bent_face(states), normals);
    for (std::size_t j = 0; j < 8; ++j) {
        const double turned = 0.2 * double(j);
        const Vec3 face(0, std::cos(turned), std::sin(turned));
        EXPECT_LT((face_at(normals, j, false) - face.cast<float>()).norm(), 2e-5f) << j;
    }
}

}  // namespace
}  // namespace lancret
