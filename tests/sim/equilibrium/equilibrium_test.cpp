#include "sim/equilibrium/equilibrium.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/equilibrium/branch.h"
#include "sim/equilibrium/measures.h"
#include "sim/equilibrium/minimum.h"
#include "tests/sim/rod/made_rods.h"
#include "tests/sim/rod/rod_gradient.h"

namespace lancret {
namespace {

/// The norm of the gradient scaled by (K l)^(-1/2), in units of sqrt(EI / L).
double residual(const HangingRod& rod, const Eigen::VectorXd& q) {
    return rod_gradient(rod, q).cwiseQuotient(stiffness_diagonal(rod).cwiseSqrt()).norm();
}

TEST(RodEquilibrium, WithoutWeightIsTheNaturalShape) {
    const HangingRod rod = hanging_rod(7, 0, {1, 2, 3});
    const RodEquilibrium hung = rod_equilibrium(rod);
    EXPECT_EQ(hung.q, natural_curvatures(rod));
    EXPECT_TRUE(hung.stable);
    EXPECT_FALSE(hung.left_branch);
    EXPECT_NEAR(hung.smallest_eigenvalue, 1, 1e-15);
}

TEST(RodEquilibrium, IsAStableMinimumForAnyWeightShapeAndRoot) {
    // Newton's method stops when a step is below 1e-9 of the curvatures; since it
    // converges quadratically, only round-off remains, 1e-16 of the weight.
    for (const int segments : {1, 2, 5, 20}) {
        for (const double gamma : {1., 30., 1e3, 1e5}) {
            for (const Vec3& natural :
                 {Vec3(0, 0, 0), Vec3(0, 0, 8 * kPi), Vec3(8 * kPi, 3, -8 * kPi)}) {
                for (const Vec3& way : {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1),
                                        Vec3(0.6, 0, 0.8), Vec3(Vec3(2, -3, 6) / 7)}) {
                    const HangingRod rod =
                        made_rod(segments, gamma, natural, way, way.unitOrthogonal());
                    const RodEquilibrium hung = rod_equilibrium(rod);
                    EXPECT_TRUE(hung.converged && hung.stable)
                        << segments << " " << gamma << " n " << natural.transpose()
                        << " t " << way.transpose();
                    EXPECT_LT(residual(rod, hung.q), 1e-10 + 1e-13 * gamma);
                    // Round-off is 1e-15 of the terms of the energy, up to the weight.
                    EXPECT_LE(
                        hung.energy.total(),
                        rod_energy(rod, natural_curvatures(rod)).total() + 1e-15 * gamma);
                }
            }
        }
    }
}

TEST(RodEquilibrium, TurnsWithTheWorld) {
    // Root frame and gravity turn together, so the curvatures stay the same, to the
    // residual of 1e-10 over the smallest eigenvalue, here above 0.1.
    const HangingRod rod = hanging_rod(20, 100, {2, 1, 5});
    HangingRod turned = rod;
    const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(2, -3, 6) / 7).toRotationMatrix();
    turned.root.frame = turn * rod.root.frame;
    turned.gravity = turn * rod.gravity;
    turned.root.position = {1, 2, 3};
    const RodEquilibrium a = rod_equilibrium(rod), b = rod_equilibrium(turned);
    EXPECT_LT((a.q - b.q).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_NEAR(a.energy.total(), b.energy.total(), 1e-10 * 100);
}

TEST(RodEquilibrium, DependsOnlyOnTheWeightNumber) {
    // In centimetres, grams and seconds lengths scale by L, curvatures by 1 / L.
    const double length = 12, ei = 0.7, density = 6e-5, gamma = 10;
    HangingRod rod = made_rod(20, 0, {0.1, 0, 0.05});
    rod.lengths.assign(20, length / 20);
    rod.section.stiffness = ei * Vec3(2. / 3, 1, 1);
    rod.section.linear_density = density;
    rod.gravity = Vec3(0, 0, -gamma * ei / (density * std::pow(length, 3)));
    EXPECT_NEAR(weight_number(rod), gamma, 1e-12);
    const HangingRod one = made_rod(20, gamma, length * Vec3(0.1, 0, 0.05));
    const RodEquilibrium a = rod_equilibrium(rod), b = rod_equilibrium(one);
    EXPECT_LT((length * a.q - b.q).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_NEAR(a.energy.total() * length / ei, b.energy.total(), 1e-10);
}

TEST(RodEquilibrium, UprightRodBucklesTowardsN1) {
    // Above the critical weight of 7.84. Its tip bends towards n1 = x, and turning it
    // about the vertical does not change the energy: a neutral direction.
    const HangingRod rod = made_rod(10, 12, {0, 0, 0}, Vec3::UnitZ(), Vec3::UnitX());
    const RodEquilibrium hung = rod_equilibrium(rod);
    EXPECT_TRUE(hung.left_branch && hung.stable);
    EXPECT_GT(tip_of(rod, hung.q).x(), 0.3);
    EXPECT_NEAR(tip_of(rod, hung.q).y(), 0, 1e-9);
    EXPECT_NEAR(hung.smallest_eigenvalue, 0, neutral_eigenvalue(rod));
    const RodEquilibrium kept = rod_equilibrium(rod, Branch::keep);
    EXPECT_FALSE(kept.left_branch || kept.stable);
    EXPECT_LT(kept.smallest_eigenvalue, -0.1);
    EXPECT_LT(kept.q.cwiseAbs().maxCoeff(), 1e-9);
}

TEST(RodEquilibrium, RingInItsUnstableWindowLeavesItsPlane) {
    const HangingRod rod = hanging_rod(20, 30, {0, 0, 2 * kPi});
    const RodEquilibrium kept = rod_equilibrium(rod, Branch::keep);
    EXPECT_TRUE(kept.converged);
    EXPECT_FALSE(kept.stable);
    EXPECT_NEAR(tip_of(rod, kept.q).y(), 0, 1e-9);
    const RodEquilibrium left = rod_equilibrium(rod);
    EXPECT_TRUE(left.left_branch && left.stable);
    EXPECT_GT(std::abs(tip_of(rod, left.q).y()), 0.1);
    EXPECT_LT(left.energy.total(), kept.energy.total());
}

TEST(RodEquilibrium, TightRingSnapsInItsPlaneAndEndsThere) {
    // Three half turns uncoil over a fold at Gamma = 76; beyond 199.7 the plane is
    // stable.
    const RodEquilibrium hung = rod_equilibrium(hanging_rod(20, 250, {0, 0, 3 * kPi}));
    EXPECT_EQ(hung.snaps, 1);
    EXPECT_TRUE(hung.left_branch && hung.stable);
    for (std::size_t i = 0; i < 20; ++i) EXPECT_NEAR(hung.q(3 * i + 1), 0, 1e-8);
}

TEST(RodMinimum, KeepsASaddleIfRequested) {
    const HangingRod rod = made_rod(5, 12, {0, 0, 0}, Vec3::UnitZ(), Vec3::UnitX());
    const Eigen::VectorXd straight = natural_curvatures(rod);
    EXPECT_EQ(rod_minimum(rod, straight, Saddles::keep).q, straight);
    EXPECT_GE(rod_minimum(rod, straight).escapes, 1);
}

TEST(RodMeasures, LowestPointOfARingIsItsDiameter) {
    // A weightless ring of radius 1 / 2 pi that starts sideways: its centre is a radius
    // below the root, its lowest point a diameter below it, half way round.
    const HangingRod rod = made_rod(3, 0, {0, 0, -2 * kPi});
    const LowestPoint low = lowest_point(rod, natural_curvatures(rod), Vec3::UnitZ());
    EXPECT_NEAR(low.height, -1 / kPi, 1e-15);
    EXPECT_NEAR(low.s, 0.5, 1e-12);
}

TEST(RodMeasures, TipAngleOfAnArcIsItsTurn) {
    const HangingRod rod = made_rod(4, 0, {0, 1.2, -1.6});
    EXPECT_NEAR(tip_angle(rod, natural_curvatures(rod)), 2, 1e-14);
}

TEST(RodMeasures, RootCurvatureOfAStiffRodIsItsMoment) {
    // Straight to O(Gamma): M = rho S g L^2 / 2, about the horizontal -n2 for n1 up.
    const HangingRod rod = made_rod(6, 1e-6);
    const Vec3 root = root_darboux(rod, rod_equilibrium(rod).q);
    EXPECT_NEAR(root.z(), -0.5e-6, 1e-12);
    EXPECT_NEAR(root.head<2>().norm(), 0, 1e-15);
}

}  // namespace
}  // namespace lancret
