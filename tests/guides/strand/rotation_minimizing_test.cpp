#include "guides/strand/rotation_minimizing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "guides/helix/helix.h"

namespace lancret {
namespace {

constexpr double kCurvature = 1.5, kTorsion = 0.8, kLength = 4;

struct Helix {
    std::vector<Vec3> positions, tangents;
    std::vector<Mat3> frames;  ///< Frenet
};

Helix sampled_helix(int n) {
    Helix helix;
    for (int i = 0; i <= n; ++i) {
        HelixState<double> state;
        advance<double>(state, Vec3(kTorsion, 0, kCurvature), kLength * i / n);
        helix.positions.push_back(state.position);
        helix.tangents.push_back(state.frame.col(0));
        helix.frames.push_back(state.frame);
    }
    return helix;
}

/// The angle at the tip between the frames and the exact ones: N' = -kappa T + tau B, so
/// the Frenet frame turns about T by tau ds against a rotation-minimising one.
double tip_error(const Mat3& tip, const Mat3& frenet) {
    const double turn = kTorsion * kLength;
    const Vec3 exact = std::cos(turn) * frenet.col(1) - std::sin(turn) * frenet.col(2);
    return (tip.col(1) - exact).norm();
}

double reflected_error(int n) {
    const Helix h = sampled_helix(n);
    return tip_error(
        rotation_minimizing_frames(h.positions, h.tangents, h.frames[0].col(1)).back(),
        h.frames.back());
}

double transported_error(int n) {
    const Helix h = sampled_helix(n);
    return tip_error(rotation_minimizing_frames(h.tangents, h.frames[0].col(1)).back(),
                     h.frames.back());
}

TEST(RotationMinimizing, ReflectionIsOfOrderFourOnAHelix) {
    for (int n : {20, 40, 80}) {
        const double order = std::log2(reflected_error(n) / reflected_error(2 * n));
        std::printf("n = %d: error %.3g, order %.2f\n", n, reflected_error(n), order);
        EXPECT_NEAR(order, 4.0, 0.1);
    }
}

TEST(RotationMinimizing, SmallestRotationIsOfOrderTwoOnAHelix) {
    for (int n : {20, 40, 80}) {
        const double order = std::log2(transported_error(n) / transported_error(2 * n));
        std::printf("n = %d: error %.3g, order %.2f\n", n, transported_error(n), order);
        EXPECT_NEAR(order, 2.0, 0.1);
    }
}

TEST(RotationMinimizing, FramesAreRightHandedAndOrthonormal) {
    const Helix h = sampled_helix(1000);
    for (const Mat3& f :
         rotation_minimizing_frames(h.positions, h.tangents, Vec3(0.1, 0.2, 0.7))) {
        EXPECT_LT((f.transpose() * f - Mat3::Identity()).cwiseAbs().maxCoeff(), 1e-15);
        EXPECT_GT(f.determinant(), 0);
    }
}

TEST(RotationMinimizing, StraightStrandKeepsItsNormal) {
    const Vec3 along = Vec3(1, 2, 2) / 3;
    std::vector<Vec3> positions, tangents(20, along);
    for (int i = 0; i < 20; ++i) positions.push_back(0.1 * i * along);
    const Vec3 hint(0, 0, 5), normal = across_tangent(hint, along);
    EXPECT_LT((normal - (hint - along * along.z() * 5).normalized()).norm(), 1e-15);
    for (const Mat3& f : rotation_minimizing_frames(positions, tangents, hint)) {
        EXPECT_LT((f.col(1) - normal).norm(), 1e-14);
    }
}

TEST(RotationMinimizing, PlanarStrandKeepsItsBinormalThroughAHairpin) {
    // Opposite tangents from one sample to the next, then a repeated position.
    const std::vector<Vec3> tangents{{1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {1, 0, 0}};
    const std::vector<Vec3> positions{{0, 0, 0}, {1, 1, 0}, {1, 1, 0}, {1, 1, 0}};
    for (const auto& frames :
         {rotation_minimizing_frames(positions, tangents, Vec3(0, 0, 1)),
          rotation_minimizing_frames(tangents, Vec3(0, 0, 1))}) {
        for (const Mat3& f : frames) EXPECT_NEAR(std::abs(f(2, 1)), 1, 1e-14);
    }
}

TEST(RotationMinimizing, HintAlongTheTangentStillGivesANormal) {
    for (const Vec3& hint : {Vec3(0, 0, 0), Vec3(0, 3, 0), Vec3(1e-12, 1, 0)}) {
        const Vec3 normal = across_tangent(hint, Vec3(0, 1, 0));
        EXPECT_NEAR(normal.norm(), 1, 1e-15);
        EXPECT_EQ(normal.y(), 0);
    }
}

}  // namespace
}  // namespace lancret
