#pragma once
// A rod that steps, for tests.

#include <functional>

#include "sim/equilibrium/release.h"
#include "sim/rod/step.h"
#include "tests/sim/rod/rods.h"

namespace lancret {

/// The motion of a root over time.
using RootAt = std::function<RootMotion(double time)>;

/// A root that swings smoothly along a line and about a fixed axis.
inline RootMotion swinging_root(double t) {
    RootMotion out;
    const Vec3 axis = Vec3(1, 2, -1).normalized(), way(0.2, -0.1, 0.3);
    const double turn = 0.5 * std::sin(3 * t);
    out.pose.frame = helix_step<double>(turn * axis, 1).rotation;
    out.pose.position = way * std::sin(2 * t);
    out.velocity = way * 2 * std::cos(2 * t);
    out.acceleration = way * -4 * std::sin(2 * t);
    out.angular_velocity = axis * 1.5 * std::cos(3 * t);
    out.angular_acceleration = axis * -4.5 * std::sin(3 * t);
    return out;
}

/// A test rod in motion.
struct RodRun {
    TestRod rod;
    RodForces forces;
    StepSettings settings;
    RootAt root_at;
    double time = 0;
    RodStepper stepper;
    RodPast past;
    StepReport report;

    void step(double eps) {
        if (root_at) rod.root = root_at(time);
        const RootMotion to = root_at ? root_at(time + eps) : rod.root;
        report = stepper.step(rod.rod(), forces, settings,
                              {rod.root, to.pose, eps, rod.curvatures, rod.rates, past});
        rod.root = to;
        time += eps;
    }
    void run(double duration, int steps) {
        for (int i = 0; i < steps; ++i) step(duration / steps);
    }
    Vec3 tip() const {
        HelixState<double> at = rod.root.pose;
        for (std::size_t q = 0; q < rod.lengths.size(); ++q) {
            advance<double>(at, rod.curvatures[q], rod.lengths[q]);
        }
        return at.position;
    }
};

/// A curled rod of n segments, gravity `gamma` along -z, in its natural shape.
inline RodRun curled_run(int segments, double gamma, Integrator integrator) {
    RodRun out;
    out.rod = straight_rod(segments);
    out.rod.natural.assign(segments, Vec3(1, 0, 5));
    out.rod.curvatures = out.rod.natural;
    out.rod.section.stiffness = {2. / 3, 1, 1};
    out.forces.gravity = {0, 0, -gamma};
    out.settings = to_round_off(integrator);
    return out;
}

}  // namespace lancret
