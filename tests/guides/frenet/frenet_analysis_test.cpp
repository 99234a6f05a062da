#include "guides/frenet/frenet_analysis.h"

#include <gtest/gtest.h>

#include <cmath>

#include "guides/strand/rotation_minimizing.h"
#include "tests/guides/frenet/frenet_paths.h"

namespace lancret {
namespace {

TEST(FrenetAnalysis, PointValuesOfAHelixAreItsClosedForm) {
    for (double b : {0.6, -0.6}) {
        // An arbitrary parameter: v = w + 0.3 sin w, by the chain rule.
        const Path path = [b](double w) {
            const double v = w + 0.3 * std::sin(w), v1 = 1 + 0.3 * std::cos(w),
                         v2 = -0.3 * std::sin(w), v3 = -0.3 * std::cos(w);
            const CurvePoint x = helix(v, 1.5, b);
            return CurvePoint{x.position, x.d1 * v1, x.d2 * v1 * v1 + x.d1 * v2,
                              x.d3 * v1 * v1 * v1 + 3 * v1 * v2 * x.d2 + v3 * x.d1};
        };
        const Sampled x = sampled(path, 0, 9, 60);
        const double w2 = 1.5 * 1.5 + b * b;
        for (const FrenetPoint& p : frenet_points(x.points, Vec3::UnitX())) {
            EXPECT_NEAR(p.rates.curvature, 1.5 / w2, 1e-14);
            EXPECT_NEAR(p.rates.torsion, b / w2, 1e-14);
            // N points to the axis.
            Vec3 inward = -p.state.position / 1.5;
            inward.z() = 0;
            EXPECT_LT((p.state.frame.col(1) - inward).norm(), 1e-13);
        }
        // The frames are those of a helix at any step, so the round trip is exact.
        EXPECT_LT(round_trip_error(x, FrenetMethod::frames), 1e-12);
        EXPECT_LT(round_trip_error(x, FrenetMethod::point_values), 1e-12);
    }
}

TEST(FrenetAnalysis, CircleHasNoTorsion) {
    const Sampled x = sampled([](double v) { return helix(v, 2, 0); }, 0, 2 * kPi, 12);
    for (const FrenetMethod method : {FrenetMethod::frames, FrenetMethod::point_values}) {
        for (const FrenetRates& r : profile_of(x, method).rates) {
            EXPECT_NEAR(r.curvature, 0.5, 1e-14);
            EXPECT_NEAR(r.torsion, 0, 1e-14);
        }
    }
}

TEST(FrenetAnalysis, InflectionKeepsTheBinormalAndChangesTheSign) {
    for (int n : {40, 41}) {
        const Sampled x = sampled(cubic_inflection, -1, 1, n);
        const auto points = frenet_points(x.points, Vec3::UnitZ());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double at = x.points[i].position.x();
            // The strand bends to the right first, so N points to the right.
            EXPECT_NEAR(points[i].state.frame(2, 2), -1, 1e-14);
            EXPECT_NEAR(points[i].rates.curvature,
                        -6 * at / std::pow(1 + 9 * std::pow(at, 4), 1.5), 1e-13);
            EXPECT_NEAR(points[i].rates.torsion, 0, 1e-12);
        }
    }
}

TEST(FrenetAnalysis, ClothoidHasCurvatureLinearInArcLength) {
    // Angle c (s - 2)^2 / 2, so kappa = c (s - 2), through zero at s = 2. Over an
    // interval the turn is exactly c ds times the middle: the mean of kappa, by both
    // methods.
    const double c = 0.8, ds = 0.1;
    std::vector<CurvePoint> samples;
    Vec3 at = Vec3::Zero();
    for (int i = 0; i <= 40; ++i) {
        const double u = ds * i - 2, angle = c * u * u / 2;
        const Vec3 t(std::cos(angle), std::sin(angle), 0), n(-t.y(), t.x(), 0);
        samples.push_back({at, t, c * u * n, c * n - c * c * u * u * t});
        at += ds * t;  // accurate enough: positions only carry the frame
    }
    const auto points = frenet_points(samples, Vec3::UnitZ());
    const std::vector<double> steps(40, ds);
    for (const FrenetProfile& profile : {profile_of_frames(states_of(points), steps),
                                         profile_of_points(points, steps)}) {
        for (int i = 0; i < 40; ++i) {
            EXPECT_NEAR(profile.rates[i].curvature, -c * (ds * (i + 0.5) - 2), 1e-13);
            EXPECT_NEAR(profile.rates[i].torsion, 0, 1e-13);
        }
    }
}

TEST(FrenetAnalysis, StraightStrandTakesTheHint) {
    const Vec3 along = Vec3(2, -1, 2) / 3, hint(0, 1, 0);
    const std::vector<Vec3> ends{Vec3(1, 1, 1), Vec3(1, 1, 1) + 4 * along};
    const FrenetProfile profile = analyze(*curve_through(ends), 8, hint);
    EXPECT_LT((profile.root.frame.col(1) - across_tangent(hint, along)).norm(), 1e-15);
    for (const FrenetRates& r : profile.rates) EXPECT_LT(r.darboux().norm(), 1e-14);
    EXPECT_LT((synthesize(profile).back().position - ends[1]).norm(), 1e-14);
}

TEST(FrenetAnalysis, RootWithoutSpeedTakesTheTangentAfterIt) {
    // A B-spline with tripled outer control points starts and stops at rest.
    std::vector<Vec3> control(3, Vec3(0, 0, 0));
    control.insert(control.end(),
                   {{0, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 2, 0}, {2, 2, 0}});
    const Curve curve = *bspline_curve(control);
    ASSERT_EQ(evaluate(curve, 0).d1.norm(), 0);
    const FrenetProfile profile = analyze(curve, 400, Vec3::UnitX());
    // x(t) = t^3 / 6 (0, 1, 0) to begin with: straight for the first piece.
    EXPECT_LT((profile.root.frame.col(0) - Vec3::UnitY()).norm(), 1e-2);
    EXPECT_NEAR(std::abs(profile.root.frame(2, 2)), 1, 1e-12);
    EXPECT_LT((synthesize(profile).back().position - Vec3(2, 2, 0)).norm(), 1e-4);
}

/// The turn over its length, radians, that a straight strand can seem to have if its
/// points are off by `position_error` (cm): errors of alternating sign give a spline with
/// chords h a second derivative of 12 errors / h^2.
double noise_turn(const Curve& curve, double position_error) {
    const double chord = curve.length() / double(curve.pieces.size());
    return 12 * position_error / (chord * chord) * curve.length();
}

TEST(FrenetAnalysis, RoundOffOfFloatsIsNoBend) {
    // A line 100 cm from the origin in floats: half an ulp is 2^-18 = 3.8e-6 cm per axis.
    std::vector<Vec3f> points;
    for (int i = 0; i <= 30; ++i) {
        points.push_back(
            (Vec3(100, 90, -80) + 0.3 * i * Vec3(0.71, -0.33, 0.62)).cast<float>());
    }
    const Curve curve = *curve_through(points);
    const double error = 3.8e-6 * std::sqrt(3.0), turn = noise_turn(curve, error);
    double noise = 0;
    for (const FrenetRates& r : analyze(curve, 60, Vec3::UnitY()).rates) {
        noise = std::max(noise, std::abs(r.torsion));
    }
    EXPECT_GT(noise, 1);
    const FrenetProfile profile =
        analyze(curve, 60, Vec3::UnitY(), FrenetMethod::frames, turn);
    // What remains is the turn of the tangents, below the noise, and twist of the order
    // of its square.
    for (const FrenetRates& r : profile.rates) {
        EXPECT_LT(std::abs(r.curvature), turn / curve.length());
        EXPECT_LT(std::abs(r.torsion), turn * turn / curve.length());
    }
}

/// An arc about z, a straight stretch along y, then an arc in a plane turned by 1 radian.
std::vector<CurvePoint> arcs_with_a_stretch(int n) {
    std::vector<CurvePoint> out;
    const double ds = 3.0 / n;
    HelixState<double> state;
    for (int i = 0; i <= n; ++i) {
        const double middle = ds * (i + 0.5);
        const double kappa = middle < 1 || middle > 2 ? 1.0 : 0.0;
        // At the joints of the arcs the second derivative is that of the arc.
        const bool bends = ds * i < 1 - 1e-9 || ds * i > 2 + 1e-9;
        out.push_back({state.position, state.frame.col(0),
                       (bends ? 1.0 : 0.0) * state.frame.col(1),
                       (bends ? -1.0 : 0.0) * state.frame.col(0)});
        if (middle > 2 && middle - ds < 2) {  // turn the plane, once
            state.frame = state.frame * helix_step<double>(Vec3(1, 0, 0), 1).rotation;
        }
        advance<double>(state, Vec3(0, 0, kappa), ds);
    }
    return out;
}

TEST(FrenetAnalysis, StretchBetweenTwoArcsTwistsOnlyAtItsMiddle) {
    const int n = 30;
    const std::vector<CurvePoint> samples = arcs_with_a_stretch(n);
    const auto points = frenet_points(samples, Vec3::UnitX());
    const std::vector<double> steps(n, 3.0 / n);
    const FrenetProfile profile = profile_of_frames(states_of(points), steps);
    double twist = 0;
    int twisted = 0;
    for (int i = 0; i < n; ++i) {
        const double turn = profile.rates[i].torsion * steps[i];
        twist += turn;
        if (std::abs(turn) < 1e-12) continue;
        ++twisted;
        EXPECT_NEAR((i + 0.5) * steps[i], 1.5, 0.11);
    }
    EXPECT_EQ(twisted, 1);
    EXPECT_NEAR(twist, 1, 1e-12);
    const auto strand = synthesize(profile);
    for (int i = 0; i <= n; ++i) {
        EXPECT_LT((strand[i].position - samples[i].position).norm(), 1e-13);
    }
}

TEST(FrenetAnalysis, StraightRootTakesTheNormalOfTheFirstBend) {
    // The last two thirds of the arcs: a stretch, then an arc.
    const std::vector<CurvePoint> samples = arcs_with_a_stretch(30);
    const auto points = frenet_points(std::span(samples).subspan(12), Vec3::UnitX());
    const Vec3 normal = samples.back().d2;
    const Vec3 binormal = samples.back().d1.cross(normal);
    for (const FrenetPoint& p : points) {
        EXPECT_LT((p.state.frame.col(2) - binormal).norm(), 1e-13);
    }
}

TEST(FrenetAnalysis, TorsionKeepsTheFrameRightHanded) {
    for (const FrenetPoint& p :
         frenet_points(sampled(twisted_cubic, -1, 1, 50).points, Vec3::UnitZ())) {
        const Mat3& f = p.state.frame;
        EXPECT_LT((f.transpose() * f - Mat3::Identity()).cwiseAbs().maxCoeff(), 1e-15);
        EXPECT_GT(f.determinant(), 0);
        EXPECT_GT(p.rates.torsion, 0);  // (x' x x'') . x''' = 12 > 0
    }
}

}  // namespace
}  // namespace lancret
