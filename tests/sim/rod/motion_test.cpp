#include "tests/sim/rod/motion.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/sim/rod/rod_runs.h"

namespace lancret {
namespace {

constexpr double kDrag = 0.3;
const Vec3 kGravity(0.5, -1, -4);

/// The force of drag and weight and its moment about the origin.
Momentum outer_forces(const TestRod& rod) {
    // Both are integrals of a velocity or an acceleration over the mass, as momentum is.
    const Momentum p = momentum(rod.rod(), rod.state());
    TestRod falling = rod;
    falling.rates.assign(rod.rates.size(), Vec3::Zero());
    falling.root = {rod.root.pose};
    falling.root.velocity = kGravity;
    const Momentum weight = momentum(falling.rod(), falling.state());
    const double share = kDrag / rod.section.linear_density;
    return {weight.linear - share * p.linear, weight.angular - share * p.angular};
}

TEST(RodMotion, MomentumAndEnergyAreThoseOfATurningRod) {
    // A straight rod of length 1 and mass 1 that turns about its end: L = w / 3,
    // T = w^2 / 6, P = w / 2.
    TestRod rod = straight_rod(3);
    rod.root.angular_velocity = {0, 0, 2};
    const Momentum p = momentum(rod.rod(), rod.state());
    EXPECT_LT((p.linear - Vec3(0, 1, 0)).norm(), 1e-14);
    EXPECT_LT((p.angular - Vec3(0, 0, 2. / 3)).norm(), 1e-14);
    const RodEnergy e = energy(rod.rod(), rod.state(), {0, -3, 0});
    EXPECT_NEAR(e.kinetic, 2. / 3, 1e-14);
    EXPECT_EQ(e.elastic, 0);
    EXPECT_NEAR(e.gravity, 0, 1e-14);
}

TEST(RodMotion, RootReactionBalancesTheMomentum) {
    // Along q + q' t + q'' t^2 / 2 with a swinging root: F + weight + drag = dP/dt, and
    // the same for moments about the origin. Differences of step 1e-4 have an error of
    // 1e-8 times the third derivatives, which are up to 100.
    std::mt19937_64 random(12);
    for (int trial = 0; trial < 8; ++trial) {
        TestRod rod = random_rod(5, 0.6, random);
        std::vector<Vec3> accelerations(5);
        for (Vec3& a : accelerations) a = random_vector(random, 10);
        const auto rod_at = [&](double t) {
            TestRod out = rod;
            out.root = swinging_root(0.3 + t);
            for (int q = 0; q < 5; ++q) {
                out.curvatures[q] += t * rod.rates[q] + t * t / 2 * accelerations[q];
                out.rates[q] += t * accelerations[q];
            }
            return out;
        };
        const auto momentum_at = [&](double t) {
            const TestRod then = rod_at(t);
            return momentum(then.rod(), then.state());
        };
        const TestRod now = rod_at(0);
        const RootReaction held =
            root_reaction(now.rod(), now.state(), accelerations, kGravity, kDrag);
        const Momentum outer = outer_forces(now);
        constexpr double h = 1e-4;
        const Momentum before = momentum_at(-h), after = momentum_at(h);
        const Vec3 force = (after.linear - before.linear) / (2 * h) - outer.linear;
        const Vec3 moment = (after.angular - before.angular) / (2 * h) - outer.angular -
                            now.root.pose.position.cross(held.force);
        EXPECT_LT((held.force - force).norm(), 1e-6);
        EXPECT_LT((held.moment - moment).norm(), 1e-6);
    }
}

/// The difference between the impulses of root, weight and drag over a run and the change
/// of momentum: linear and angular, relative to the largest root reaction.
std::pair<double, double> impulse_error(int steps) {
    RodRun run = curled_run(5, 0, Integrator::bdf2);
    run.rod.section.damping = 0.05 * run.rod.section.stiffness;
    run.forces.gravity = kGravity;
    run.forces.drag = kDrag;
    run.root_at = swinging_root;
    run.rod.root = swinging_root(0);
    const double eps = 1. / steps;
    // Starts after BDF2 has settled, when all rates are of second order.
    run.run(0.2, steps / 5);
    const auto now = [&] { return momentum(run.rod.rod(), run.rod.state()); };
    const Momentum first = now();
    Momentum sum;
    double size = 0;
    TestRod middle = run.rod;
    for (int i = 0; i < steps; ++i) {
        const TestRod before = run.rod;
        run.step(eps);
        std::vector<Vec3> accelerations(5);
        for (int q = 0; q < 5; ++q) {
            accelerations[q] = (run.rod.rates[q] - before.rates[q]) / eps;
            middle.rates[q] = (run.rod.rates[q] + before.rates[q]) / 2;
            middle.curvatures[q] = (run.rod.curvatures[q] + before.curvatures[q]) / 2;
        }
        middle.root = swinging_root(run.time - eps / 2);
        const RootReaction held =
            root_reaction(middle.rod(), middle.state(), accelerations, kGravity, kDrag);
        const Momentum outer = outer_forces(middle);
        const Vec3 moment = held.moment + middle.root.pose.position.cross(held.force);
        sum.linear += eps * (held.force + outer.linear);
        sum.angular += eps * (moment + outer.angular);
        size = std::max({size, held.force.norm(), moment.norm()});
    }
    const Momentum last = now();
    return {(sum.linear - (last.linear - first.linear)).norm() / size,
            (sum.angular - (last.angular - first.angular)).norm() / size};
}

TEST(RodMotion, RootsImpulseOverARunIsTheChangeOfMomentum) {
    // Of second order in the step, as midpoints and BDF2's rates are.
    const auto [linear, angular] = impulse_error(500);
    const auto [finer_linear, finer_angular] = impulse_error(1000);
    fmt::print("linear {:.2e} {:.2e}, angular {:.2e} {:.2e}\n", linear, finer_linear,
               angular, finer_angular);
    EXPECT_LT(finer_linear, 1e-3);
    EXPECT_LT(finer_angular, 1e-3);
    EXPECT_NEAR(std::log2(linear / finer_linear), 2, 0.4);
    EXPECT_NEAR(std::log2(angular / finer_angular), 2, 0.4);
}

}  // namespace
}  // namespace lancret
