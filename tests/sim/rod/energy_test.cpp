#include "sim/rod/energy.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

#include "sim/rod/mass.h"
#include "sim/segment/gauss_legendre.h"
#include "tests/sim/rod/made_rods.h"
#include "tests/sim/rod/rod_gradient.h"

namespace lancret {
namespace {

/// A rod of uneven segments in a slanted frame, and a shape of it: curvatures up to
/// `size`, one segment straight.
HangingRod uneven_rod() {
    HangingRod rod = made_rod(5, 7, {2, -1, 3});
    rod.root.frame = Eigen::AngleAxisd(0.7, Vec3(1, 2, 2) / 3).toRotationMatrix();
    rod.root.position = {3, -2, 1};
    rod.lengths = {0.1, 0.3, 0.25, 0.15, 0.2};
    rod.gravity = {1, 2, -6};
    rod.section.stiffness = {0.5, 1, 2};
    rod.section.linear_density = 1.5;
    return rod;
}

Eigen::VectorXd shape(const HangingRod& rod, double size) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> spread(-size, size);
    Eigen::VectorXd q(3 * rod.segments());
    for (double& k : q) k = spread(random);
    q.segment<3>(6).setZero();
    return q;
}

const double kSizes[] = {0, 1e-4, 3, 40};

// Central differences of step h of a function of size s have the errors h^2 s / 6 (from
// the third derivative; all derivatives of a rod of length 1 are of the same size, here
// rho S g L^2 < 10, and the third derivative of the elastic energy is zero) and eps s /
// h, where s is the energy 1/2 K k^2 < 5000 at curvatures of 40.
constexpr double kStep = 1e-5;

double difference_error(double size) {
    return kStep * kStep * 10 + 4e-16 * (10 + 3 * size * size) / kStep;
}

TEST(RodEnergy, GradientIsTheEnergysDifference) {
    const HangingRod rod = uneven_rod();
    for (const double size : kSizes) {
        const Eigen::VectorXd q = shape(rod, size), gradient = rod_gradient(rod, q);
        for (Eigen::Index i = 0; i < q.size(); ++i) {
            const Eigen::VectorXd h = kStep * Eigen::VectorXd::Unit(q.size(), i);
            const double want =
                (rod_energy(rod, q + h).total() - rod_energy(rod, q - h).total()) /
                (2 * kStep);
            EXPECT_NEAR(gradient(i), want, difference_error(size)) << size << " " << i;
        }
    }
}

TEST(RodEnergy, HessianIsTheGradientsDifference) {
    const HangingRod rod = uneven_rod();
    for (const double size : kSizes) {
        const Eigen::VectorXd q = shape(rod, size);
        const Eigen::MatrixXd hessian = rod_hessian(rod, q);
        EXPECT_EQ(hessian, hessian.transpose());
        for (Eigen::Index i = 0; i < q.size(); ++i) {
            const Eigen::VectorXd h = kStep * Eigen::VectorXd::Unit(q.size(), i);
            const Eigen::VectorXd want =
                (rod_gradient(rod, q + h) - rod_gradient(rod, q - h)) / (2 * kStep);
            EXPECT_LT((hessian.col(i) - want).norm(), 4 * difference_error(size))
                << size << " " << i;
        }
    }
}

TEST(RodEnergy, GravityActsOnTheMiddleOfAStraightRod) {
    // -rho S g . L^2 / 2 along the tangent.
    const HangingRod rod = uneven_rod();
    const Eigen::VectorXd q = Eigen::VectorXd::Zero(15);
    EXPECT_NEAR(rod_energy(rod, q).gravity,
                -1.5 * rod.gravity.dot(rod.root.frame.col(0)) / 2, 1e-14);
    EXPECT_NEAR(rod_energy(rod, q).elastic, 0.5 * (0.5 * 4 + 1 * 1 + 2 * 9), 1e-13);
}

TEST(RodEnergy, OneSegmentOfManyTurnsEqualsMany) {
    // The same curve as 1 segment and as 100: a segment that turns by 300 rad needs many
    // Gauss points. Each panel is exact to 1e-10 of the weight 7 times the moment 1 of
    // the length.
    const Vec3 k(100, 200, 200);
    Eigen::VectorXd one = k, many = k.replicate(100, 1);
    HangingRod rod = made_rod(1, 7);
    const double whole = rod_energy(rod, one).gravity;
    rod = made_rod(100, 7);
    EXPECT_NEAR(rod_energy(rod, many).gravity, whole, 7e-10);
}

TEST(RodMass, KineticEnergyIsThatOfThePoints) {
    // v^T M v = rho S int |dr|^2 ds with dr by central differences of the points: twice
    // an error of 1e-10 of |dr| < 1; that of the quadrature with 32 points per segment is
    // smaller.
    const HangingRod rod = uneven_rod();
    const GaussRule rule = gauss_rule(32);
    for (const double size : kSizes) {
        const Eigen::VectorXd q = shape(rod, size);
        const Eigen::MatrixXd mass = rod_mass(rod, q);
        EXPECT_LT((mass - mass.transpose()).norm(), 1e-15);
        for (int round = 0; round < 20; ++round) {
            std::mt19937 random(round);
            std::normal_distribution<double> normal(0, 0.3);
            Eigen::VectorXd v(q.size());
            for (double& x : v) x = normal(random);
            const auto point = [&](const Eigen::VectorXd& at, std::size_t i, double u) {
                HelixState<double> state = rod_joints(rod, at)[i];
                advance<double>(state, at.segment<3>(3 * i), u);
                return state.position;
            };
            double want = 0;
            for (std::size_t i = 0; i < rod.segments(); ++i) {
                for (std::size_t g = 0; g < rule.nodes.size(); ++g) {
                    const double u = rule.nodes[g] * rod.lengths[i];
                    const Vec3 moved =
                        (point(q + kStep * v, i, u) - point(q - kStep * v, i, u)) /
                        (2 * kStep);
                    want += 1.5 * rule.weights[g] * rod.lengths[i] * moved.squaredNorm();
                }
            }
            EXPECT_NEAR(v.dot(mass * v), want, 1e-9) << size;
        }
    }
}

TEST(RodMass, NullityIsTheNumberOfStraightSegments) {
    // Round-off of eigenvalues is 1e-16 of the largest, about 1; the smallest of bent
    // segments is of the order of l^5 k^2 l^2, above 1e-9 here.
    const HangingRod rod = uneven_rod();
    const auto nullity = [&](const Eigen::VectorXd& q) {
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(rod_mass(rod, q));
        return (solver.eigenvalues().array() < 1e-13).count();
    };
    Eigen::VectorXd q = shape(rod, 3);
    EXPECT_EQ(nullity(q), 1);
    EXPECT_EQ(nullity(Eigen::VectorXd::Zero(15)), 5);
    q.segment<3>(6) = Vec3(1, 2, 0);
    EXPECT_EQ(nullity(q), 0);
}

TEST(HangingRod, InvalidRodsAreRejected) {
    const auto refuses = [](auto change) {
        HangingRod rod = uneven_rod();
        EXPECT_NO_THROW(validate_rod(rod));
        change(rod);
        EXPECT_THROW(validate_rod(rod), std::invalid_argument);
    };
    refuses([](HangingRod& r) { r.lengths[1] = 0; });
    refuses([](HangingRod& r) { r.lengths.pop_back(); });
    refuses([](HangingRod& r) { r = HangingRod(); });
    refuses([](HangingRod& r) { r.natural[2].y() = std::nan(""); });
    refuses([](HangingRod& r) { r.section.stiffness.x() = 0; });
    refuses([](HangingRod& r) { r.section.linear_density = -1; });
    refuses([](HangingRod& r) { r.root.frame.col(1) *= -1; });
    refuses(
        [](HangingRod& r) { r.gravity.z() = std::numeric_limits<double>::infinity(); });
}

}  // namespace
}  // namespace lancret
