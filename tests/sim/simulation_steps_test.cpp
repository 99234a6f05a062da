// Substeps and their adaptive halving.

#include <gtest/gtest.h>

#include "tests/sim/small_scenes.h"

namespace lancret {
namespace {

/// Hair on a head that turns.
struct Turning {
    Guides guides = hanging_groom(4, 6, 10);
    SimulationSettings settings;
    SimulationReport report;

    Guides after(int frames) {
        Simulation simulation(
            guides, settings,
            scene_of(guides, {{1, {0, 0, 0}, {0, 0, 0}}, {7, {1, 0, 0}, {0, 40, 0}}}), 1);
        for (int k = 0; k < frames; ++k) simulation.advance();
        report = simulation.take_report();
        return simulation.guides();
    }
};

TEST(SimulationSteps, ImplicitEulerIsOfFirstOrderInSubstepsAndBdf2OfSecond) {
    const auto order = [](Integrator integrator, int coarsest) {
        Turning turning;
        turning.settings.adaptive = false;
        turning.settings.step.integrator = integrator;
        turning.settings.step.tolerance = 1e-11;
        turning.settings.step.max_iterations = 60;
        Guides runs[3];
        for (int i = 0; i < 3; ++i) {
            turning.settings.substeps = coarsest << i;
            runs[i] = turning.after(6);
        }
        return std::log2(tip_distance(runs[0], runs[1]) / tip_distance(runs[1], runs[2]));
    };
    // Observed orders of three runs; terms of the next order add about 0.2 at these
    // steps. The root's acceleration jumps at the first key, where BDF2 starts with two
    // steps of Euler.
    EXPECT_NEAR(order(Integrator::implicit_euler, 64), 1, 0.2);
    EXPECT_NEAR(order(Integrator::bdf2, 64), 2, 0.4);
}

TEST(SimulationSteps, AcceptedStepsKeepTheErrorTolerance) {
    Turning turning;
    turning.settings.substeps = 1;
    turning.settings.max_halvings = 12;
    turning.settings.error_tolerance = 1e9;
    turning.after(6);
    const SimulationReport loose = turning.report;
    EXPECT_EQ(loose.steps, 4u * 6);
    EXPECT_GT(loose.largest_error, 0.2);
    std::size_t before = loose.steps;
    for (const double tolerance : {0.1, 0.01, 0.001}) {
        turning.settings.error_tolerance = tolerance;
        turning.after(6);
        EXPECT_LE(turning.report.largest_error, tolerance);
        EXPECT_GT(turning.report.steps, before) << tolerance;
        EXPECT_EQ(turning.report.unsolved, 0u);
        before = turning.report.steps;
    }
    // If the halvings do not suffice, the report shows it.
    turning.settings.max_halvings = 1;
    turning.after(6);
    EXPECT_GT(turning.report.largest_error, 0.001);
}

TEST(SimulationSteps, ATighterToleranceComesNearerToTheLimit) {
    Turning turning;
    turning.settings.adaptive = false;
    turning.settings.substeps = 512;
    const Guides limit = turning.after(6);
    turning.settings.adaptive = true;
    turning.settings.substeps = 1;
    turning.settings.max_halvings = 12;
    double before = 1e9;
    for (const double tolerance : {0.3, 0.02, 0.001}) {
        turning.settings.error_tolerance = tolerance;
        const double error = tip_distance(turning.after(6), limit);
        EXPECT_LT(error, 0.7 * before) << tolerance;
        before = error;
    }
}

TEST(SimulationSteps, AHeadThatStandsStillTakesNoHalving) {
    Turning turning;
    Simulation simulation(turning.guides, turning.settings, scene_of(turning.guides), 1);
    for (int k = 0; k < 5; ++k) simulation.advance();
    const SimulationReport report = simulation.take_report();
    EXPECT_EQ(report.steps, 4u * 4 * 5);
    EXPECT_EQ(report.unconverged, 0u);
}

}  // namespace
}  // namespace lancret
