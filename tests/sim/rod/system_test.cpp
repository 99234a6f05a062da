#include "sim/rod/system.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "guides/helix/super_helix.h"
#include "sim/segment/gauss_legendre.h"
#include "tests/sim/rod/rods.h"

namespace lancret {
namespace {

struct Linearized {
    PointLayout layout;
    PointVectors targets;
    RodSystem system;

    Linearized(const TestRod& rod, double weight) {
        layout.lay_out(rod.lengths, rod.curvatures);
        targets.resize(layout.size());
        std::mt19937_64 random(5);
        for (int i = 0; i < layout.size(); ++i) {
            targets.set(i, random_vector(random, 1));
        }
        system.linearize(rod.root.pose, rod.lengths, rod.curvatures, layout, targets,
                         weight);
    }
};

/// int J^T J ds by a rule of 32 points per quarter of a segment, with the Jacobian of the
/// guide fit.
Eigen::MatrixXd gram_reference(const TestRod& rod) {
    const SuperHelix helix{rod.root.pose, rod.lengths, rod.curvatures};
    const GaussRule rule = gauss_rule(32);
    std::vector<double> s, w;
    double start = 0;
    for (const double l : rod.lengths) {
        for (int part = 0; part < 4; ++part) {
            for (int i = 0; i < 32; ++i) {
                s.push_back(start + l * (part + rule.nodes[i]) / 4);
                w.push_back(l * rule.weights[i] / 4);
            }
        }
        start += l;
    }
    Eigen::VectorXd positions;
    Eigen::MatrixXd jacobian;
    positions_with_jacobian(helix, s, positions, jacobian);
    Eigen::MatrixXd weighted = jacobian;
    for (std::size_t i = 0; i < s.size(); ++i) weighted.middleRows(3 * i, 3) *= w[i];
    return jacobian.transpose() * weighted;
}

TEST(RodSystem, MassMatrixIsThatOfARefinedQuadrature) {
    std::mt19937_64 random(1);
    for (const double turn : {0., 1e-8, 1e-3, 0.1, 0.5, 1., 3., 10.}) {
        for (const int segments : {1, 2, 7}) {
            const TestRod rod = random_rod(segments, turn, random);
            const Linearized at(rod, 1);
            const std::vector<Vec3> zero(segments, Vec3::Zero());
            Eigen::MatrixXd matrix;
            Eigen::VectorXd force;
            at.system.assemble(zero, zero, matrix, force);
            const Eigen::MatrixXd want = gram_reference(rod);
            EXPECT_LT((matrix - want).norm(), 1e-10 * want.norm())
                << turn << " " << segments;
            EXPECT_EQ((matrix - matrix.transpose()).norm(), 0);
            // Positive semi-definite to round-off.
            Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(matrix);
            EXPECT_GT(eigen.eigenvalues().minCoeff(), -1e-14 * want.norm());
        }
    }
}

TEST(RodSystem, OneStraightSegmentHasTheClosedForm) {
    // J = u^2/2 [0, -e2, e1]: M = L^5 / 20 on the two bendings, 0 on twist.
    const TestRod rod = straight_rod(1);
    const Linearized at(rod, 1);
    const std::vector<Vec3> zero(1, Vec3::Zero());
    Eigen::MatrixXd matrix;
    Eigen::VectorXd force;
    at.system.assemble(zero, zero, matrix, force);
    const Vec3 want(0, 1. / 20, 1. / 20);
    EXPECT_LT((matrix - Eigen::MatrixXd(want.asDiagonal())).norm(), 1e-16);
}

/// The relative difference of the recursion from the dense solution, and the condition
/// number.
std::pair<double, double> recursion_error(const TestRod& rod, double diagonal,
                                          bool with_points) {
    Linearized at(rod, 1);
    const int n = int(rod.lengths.size());
    std::mt19937_64 random(7);
    std::vector<Vec3> d(n), load(n), x(n);
    for (int q = 0; q < n; ++q) {
        d[q] = diagonal * rod.lengths[q] * Vec3(0.7, 1, 1.4);
        load[q] = random_vector(random, 1e-3);
        if (with_points) {
            const Vec3 normal = random_vector(random, 1).normalized();
            at.system.add(at.system.point(q, 0.3 * rod.lengths[q]),
                          20 * normal * normal.transpose(), random_vector(random, 1));
        }
    }
    Eigen::MatrixXd matrix;
    Eigen::VectorXd force;
    at.system.assemble(d, load, matrix, force);
    at.system.solve(d, load, x);
    const Eigen::VectorXd want = matrix.ldlt().solve(force);
    Eigen::VectorXd got(3 * n);
    for (int q = 0; q < n; ++q) got.segment<3>(3 * q) = x[q];
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(matrix, Eigen::EigenvaluesOnly);
    return {(got - want).norm() / want.norm(),
            eigen.eigenvalues().maxCoeff() / eigen.eigenvalues().minCoeff()};
}

TEST(RodSystem, RecursionIsTheDenseSolution) {
    std::mt19937_64 random(2);
    for (const int segments : {1, 2, 5, 20, 60}) {
        for (const bool with_points : {false, true}) {
            const auto [error, condition] =
                recursion_error(random_rod(segments, 0.7, random), 1e-3, with_points);
            EXPECT_LT(error, 1e-9) << segments << " " << with_points;
        }
    }
}

TEST(RodSystem, RecursionIsAsGoodAsTheMatrixAllows) {
    // For small D both solvers are accurate only to eps times the condition number; the
    // recursion must not lose more.
    std::mt19937_64 random(3);
    for (const double diagonal : {1e-5, 1e-8, 1e-11}) {
        const auto [error, condition] =
            recursion_error(random_rod(40, 0.5, random), diagonal, false);
        RecordProperty("relative_error", std::to_string(error));
        EXPECT_LT(error, 2.3e-16 * condition) << diagonal << " " << condition;
    }
}

TEST(RodSystem, PointTermsAreTheirJacobians) {
    std::mt19937_64 random(4);
    const TestRod rod = random_rod(4, 0.8, random);
    const std::vector<Vec3> zero(4, Vec3::Zero());
    Eigen::MatrixXd before, after;
    Eigen::VectorXd force_before, force_after;
    Linearized at(rod, 1);
    at.system.assemble(zero, zero, before, force_before);
    const Vec3 a = random_vector(random, 1), force = random_vector(random, 1);
    const Mat3 stiffness = a * a.transpose() + 0.3 * Mat3::Identity();
    at.system.add(at.system.point(2, 0.4 * rod.lengths[2]), stiffness, force);
    at.system.assemble(zero, zero, after, force_after);
    const SuperHelix helix{rod.root.pose, rod.lengths, rod.curvatures};
    const double s = rod.lengths[0] + rod.lengths[1] + 0.4 * rod.lengths[2];
    Eigen::VectorXd positions;
    Eigen::MatrixXd j;
    positions_with_jacobian(helix, std::span(&s, 1), positions, j);
    EXPECT_LT((after - before - j.transpose() * stiffness * j).norm(),
              1e-13 * after.norm());
    EXPECT_LT((force_after - force_before - j.transpose() * force).norm(),
              1e-13 * force_after.norm());
    std::vector<Vec3> forces(4);
    at.system.forces(forces);
    for (int q = 0; q < 4; ++q) {
        EXPECT_LT((forces[q] - force_after.segment<3>(3 * q)).norm(),
                  1e-14 * force_after.norm());
    }
}

TEST(RodSystem, ForceIsTheGradientOfTheSquare) {
    // d/dq of weight int |target - r|^2 / 2 is -f. Central differences of step 1e-6.
    std::mt19937_64 random(6);
    TestRod rod = random_rod(3, 1, random);
    Linearized at(rod, 2);
    const std::vector<Vec3> zero(3, Vec3::Zero());
    Eigen::MatrixXd matrix;
    Eigen::VectorXd force;
    at.system.assemble(zero, zero, matrix, force);
    for (int q = 0; q < 3; ++q) {
        for (int i = 0; i < 3; ++i) {
            const auto value = [&](double by) {
                auto moved = rod.curvatures;
                moved[q][i] += by;
                at.system.linearize(rod.root.pose, rod.lengths, moved, at.layout,
                                    at.targets, 2);
                return at.system.half_square();
            };
            const double slope = (value(1e-6) - value(-1e-6)) / 2e-6;
            EXPECT_NEAR(-slope, force[3 * q + i], 1e-8);
        }
    }
}

}  // namespace
}  // namespace lancret
