#include "guides/frenet/constant_helicity.h"
#include "tests/guides/frenet/frenet_paths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lancret {
namespace {

/// kappa = 1.2 + 0.9 sin(2 s), so q = 1.2 s + 0.45 (1 - cos(2 s)).
ConstantHelicity wavy(double helicity) {
    return {skew_root(), helicity,
            [](double s) { return 1.2 * s + 0.45 * (1 - std::cos(2 * s)); }, 5};
}

double largest_distance(const std::vector<HelixState<double>>& a,
                        const std::vector<HelixState<double>>& b) {
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        worst = std::max(worst, (a[i].position - b[i].position).norm());
    }
    return worst;
}

TEST(ConstantHelicity, FramesAreThePapersClosedForm) {
    // [TW99, Eq. 21-24], as printed.
    const HelixState<double> root = skew_root();
    const Vec3 t = root.frame.col(0), n = root.frame.col(1), b = root.frame.col(2);
    for (double h : {-3.0, -0.4, 0.0, 1e-5, 0.9, 20.0}) {
        for (double q : {0.0, 1e-6, 0.7, 2.5, 11.0}) {
            const double w = std::sqrt(1 + h * h), l = q * w;
            const Vec3 gamma = h / w * b - 1 / w * t;
            const Vec3 tangent = t + n * std::sin(l) / w + (1 - std::cos(l)) / w * gamma;
            const Vec3 normal = n * std::cos(l) + gamma * std::sin(l);
            const Vec3 binormal =
                b - h / w * n * std::sin(l) - h * (1 - std::cos(l)) / w * gamma;
            const Mat3 frame = root.frame * constant_helicity_rotation(h, q);
            // Round-off of the angle l.
            const double tolerance = 2e-15 * (1 + l);
            EXPECT_LT((frame.col(0) - tangent).norm(), tolerance);
            EXPECT_LT((frame.col(1) - normal).norm(), tolerance);
            EXPECT_LT((frame.col(2) - binormal).norm(), tolerance);
        }
    }
}

TEST(ConstantHelicity, FramesObeyTheFrenetEquations) {
    // [TW99, Eq. 2, 4 and 5] with kappa(s) = dq/ds, by central differences: an error of
    // d^2 / 6 times a third derivative of at most (kappa w)^3 and as much from kappa'.
    const ConstantHelicity strand = wavy(0.7);
    const auto frame_at = [&](double s) {
        return Mat3(strand.root.frame *
                    constant_helicity_rotation(strand.helicity, strand.turn(s)));
    };
    const double d = 1e-4;
    for (double s : {0.5, 2.0, 4.3}) {
        const Mat3 slope = (frame_at(s + d) - frame_at(s - d)) / (2 * d);
        const double kappa = 1.2 + 0.9 * std::sin(2 * s);
        const Mat3 exact = frame_at(s) * hat<double>(kappa * Vec3(0.7, 0, 1));
        EXPECT_LT((slope - exact).norm(), d * d / 6 * 60);
    }
}

TEST(ConstantHelicity, TangentHasAConstantAngleToTheAxis) {
    // Lancret's theorem [TW99, Eq. 25], on the closed strand and on the synthesized one.
    for (double h : {-2.0, 0.0, 0.3, 5.0}) {
        const ConstantHelicity strand = wavy(h);
        const Vec3 axis = lancret_axis(strand.root.frame, h);
        const Vec3 n = strand.root.frame.col(1);
        const Vec3 gamma =
            (h * strand.root.frame.col(2) - strand.root.frame.col(0)) / std::hypot(1, h);
        EXPECT_LT((axis - n.cross(gamma)).norm(), 1e-15);
        const double cosine = h / std::hypot(1, h);
        for (const auto& states : {constant_helicity_strand(strand, 300),
                                   synthesize(constant_helicity_profile(strand, 300))}) {
            for (const auto& state : states) {
                EXPECT_NEAR(state.frame.col(0).dot(axis), cosine, 1e-13);
            }
        }
    }
}

TEST(ConstantHelicity, WithoutConstantHelicityTheAngleIsLost) {
    // The converse of the theorem: independent torsion takes the tangent off its cone.
    FrenetProfile profile = constant_helicity_profile(wavy(0.5), 300);
    const Vec3 axis = lancret_axis(profile.root.frame, 0.5);
    for (std::size_t i = 150; i < 300; ++i) profile.rates[i].torsion *= -1;
    const Vec3 tip = synthesize(profile).back().frame.col(0);
    EXPECT_GT(std::abs(tip.dot(axis) - 0.5 / std::hypot(1, 0.5)), 0.1);
}

TEST(ConstantHelicity, PositionsConvergeToThemselvesAndToACircle) {
    // 100 times as many positions change only the round-off of 1000 sums: the error of
    // parts of 1/8 cm is 4e-13 (1/8)^11 f^(10), and f^(10) is about (2 + kappa w)^10 <
    // 5e6.
    const auto coarse = constant_helicity_strand(wavy(0.7), 10),
               fine = constant_helicity_strand(wavy(0.7), 1000);
    for (int i = 0; i <= 10; ++i) {
        EXPECT_LT((coarse[i].position - fine[100 * i].position).norm(), 1000 * 1e-16);
    }
    const ConstantHelicity circle{skew_root(), 0, [](double s) { return s / 2; }, 12};
    const Vec3 centre = circle.root.position + 2 * circle.root.frame.col(1);
    for (const auto& state : constant_helicity_strand(circle, 7)) {
        EXPECT_NEAR((state.position - centre).norm(), 2, 1e-14);
    }
}

TEST(ConstantHelicity, SynthesisAgreesAtOrderTwoWithExactFrames) {
    const ConstantHelicity strand = wavy(0.7);
    double previous = 0;
    for (int n : {40, 80, 160, 320}) {
        const auto closed = constant_helicity_strand(strand, n),
                   numeric = synthesize(constant_helicity_profile(strand, n));
        for (int i = 0; i <= n; ++i) {
            EXPECT_LT((closed[i].frame - numeric[i].frame).norm(), n * 1e-15);
        }
        const double error = largest_distance(closed, numeric);
        if (previous > 0) {
            const double order = std::log2(previous / error);
            std::printf("n = %d: error %.3g, order %.2f\n", n, error, order);
            EXPECT_NEAR(order, 2.0, 0.05);
        }
        previous = error;
    }
}

TEST(ConstantHelicity, SmallHelicityIsPlanarToFirstOrder) {
    // The paper's limit: T -> T cos l + N sin l, B -> B, with an error O(h): from Eq.
    // 21-24 at most (2 + l) |h|.
    for (double h : {1e-2, -1e-4, 1e-6}) {
        const double q = 2.2, l = q * std::hypot(1, h);
        const Mat3 r = constant_helicity_rotation(h, q);
        const double bound = (2 + l) * std::abs(h);
        EXPECT_LT((r.col(0) - Vec3(std::cos(l), std::sin(l), 0)).norm(), bound);
        EXPECT_LT((r.col(1) - Vec3(-std::sin(l), std::cos(l), 0)).norm(), bound);
        EXPECT_LT((r.col(2) - Vec3::UnitZ()).norm(), bound);
    }
}

TEST(ConstantHelicity, LargeHelicityTwistsAboutAStraightTangent) {
    // T -> T, N -> N cos l +- B sin l, B -> B cos l -+ N sin l, with an error O(1/h):
    // from Eq. 21-24 at most 3 / |h|.
    for (double h : {1e2, -1e4, 1e6}) {
        const double l = 2.2, q = l / std::hypot(1, h), side = h > 0 ? 1 : -1;
        const Mat3 r = constant_helicity_rotation(h, q);
        const double bound = 3 / std::abs(h), c = std::cos(l), s = side * std::sin(l);
        EXPECT_LT((r.col(0) - Vec3::UnitX()).norm(), bound);
        EXPECT_LT((r.col(1) - Vec3(0, c, s)).norm(), bound);
        EXPECT_LT((r.col(2) - Vec3(0, -s, c)).norm(), bound);
    }
}

TEST(ConstantHelicity, RejectsZeroIntervals) {
    EXPECT_THROW(constant_helicity_strand(wavy(1), 0), std::invalid_argument);
    EXPECT_THROW(constant_helicity_profile(wavy(1), 0), std::invalid_argument);
}

}  // namespace
}  // namespace lancret
