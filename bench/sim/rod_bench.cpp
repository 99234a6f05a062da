// Microseconds per step of one guide against the number of segments: only the linear
// solution, by recursion and with the dense matrix, and whole steps of several kinds.

#include <benchmark/benchmark.h>

#include <Eigen/Dense>

#include "sim/contact/contact.h"
#include "sim/rod/step.h"
#include "tests/sim/rod/rods.h"

namespace lancret {
namespace {

/// A curled hair with 1.5 cm per segment, in the units of hair.
TestRod curled_hair(int segments) {
    std::mt19937_64 random(1);
    TestRod rod = random_rod(segments, 0.7, random);
    const double scale = 1.5 * segments;
    for (double& l : rod.lengths) l *= scale;
    for (Vec3& k : rod.natural) k /= scale;
    for (Vec3& k : rod.curvatures) k /= scale;
    for (Vec3& k : rod.rates) k = Vec3::Zero();
    rod.natural = rod.curvatures;
    rod.root = RootMotion{rod.root.pose};
    rod.section = rod_section({}, Dissipation::viscoelastic, 0.05);
    return rod;
}

/// The linear system of a step, ready to be solved.
struct LinearStep {
    TestRod rod;
    PointLayout layout;
    PointVectors targets;
    std::vector<Vec3> joints, diagonal, load, x;
    RodSystem system;
    DenseSystem dense;

    explicit LinearStep(int segments) : rod(curled_hair(segments)) {
        layout.lay_out(rod.lengths, rod.curvatures);
        point_positions(rod.lengths, rod.root.pose, rod.curvatures, layout, targets,
                        joints);
        const double eps = 1. / 96;
        for (const double l : rod.lengths) {
            diagonal.push_back(l * (eps * eps + 0.05 * eps) * rod.section.stiffness);
        }
        load.assign(diagonal.size(), Vec3::Constant(1e-3));
        x = load;
    }
    void run(LinearSolver solver) {
        system.linearize(rod.root.pose, rod.lengths, rod.curvatures, layout, targets,
                         rod.section.linear_density);
        solve(system, solver, diagonal, load, x, dense);
        benchmark::DoNotOptimize(x.data());
    }
};

void linear(benchmark::State& state, LinearSolver solver) {
    LinearStep step(int(state.range(0)));
    for (auto _ : state) step.run(solver);
    state.counters["us_per_segment"] = benchmark::Counter(
        double(state.range(0)) / 1e6,
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(linear, recursion, LinearSolver::recursion)
    ->ArgsProduct({{1, 2, 5, 8, 10, 15, 20, 50, 100, 200}})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(linear, dense_cholesky, LinearSolver::cholesky)
    ->ArgsProduct({{1, 2, 5, 8, 10, 15, 20, 50, 100, 200}})
    ->Unit(benchmark::kMicrosecond);

/// Whole steps of 1/96 s of a swinging hair, restarted before it comes to rest.
void step(benchmark::State& state, Integrator integrator, bool velocity_terms,
          bool contact) {
    const TestRod begin = curled_hair(int(state.range(0)));
    TestRod rod = begin;
    StepSettings settings;
    settings.integrator = integrator;
    settings.velocity_terms = velocity_terms;
    RodForces forces;
    forces.gravity = Vec3(0, -981, 0);
    forces.drag = 2e-4;
    RodStepper stepper;
    RodPast past;

    // A ball that supports the middle of the strand from below.
    Colliders colliders;
    const double length = rod.length();
    colliders.add(Capsule{Vec3::Zero(), Vec3::Zero(), length / 4},
                  {Mat3::Identity(), rod.root.pose.position - Vec3(0, length / 2, 0)});
    const ContactSettings contact_settings;
    const StrandContactSettings strands;
    RodContact potential(colliders, contact_settings, strands);
    const std::size_t stations =
        rod.lengths.size() * std::size_t(contact_settings.stations);
    std::vector<ContactAnchor> anchors(stations);
    const std::vector<double> allowed(stations, 0.);

    double iterations = 0;
    int count = 0;
    for (auto _ : state) {
        if (++count % 100 == 0) {
            rod = begin;
            past = {};
        }
        if (contact) {
            potential.begin({rod.lengths, anchors, allowed, {}, {}, {}, {}}, 1. / 96);
        }
        iterations +=
            stepper
                .step(rod.rod(), forces, settings,
                      {rod.root, rod.root.pose, 1. / 96, rod.curvatures, rod.rates, past},
                      contact ? &potential : nullptr)
                .iterations;
        if (contact) potential.end(stepper.system());
    }
    state.counters["iterations"] =
        benchmark::Counter(iterations, benchmark::Counter::kAvgIterations);
}
#define LANCRET_STEPS(name, ...)                    \
    BENCHMARK_CAPTURE(step, name, __VA_ARGS__)      \
        ->ArgsProduct({{1, 5, 8, 10, 20, 50, 200}}) \
        ->Unit(benchmark::kMicrosecond)
LANCRET_STEPS(semi_implicit_without_velocity_terms, Integrator::semi_implicit, false,
              false);
LANCRET_STEPS(semi_implicit, Integrator::semi_implicit, true, false);
LANCRET_STEPS(implicit, Integrator::implicit_euler, true, false);
LANCRET_STEPS(implicit_with_contact, Integrator::implicit_euler, true, true);

}  // namespace
}  // namespace lancret
