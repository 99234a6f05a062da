// Wind and drag on simulated guides.

#include <gtest/gtest.h>

#include "tests/sim/small_scenes.h"

namespace lancret {
namespace {

/// A hair that hangs from its root; soft() makes it as limp as a thread.
Guides thread() { return straight_guide(Vec3::Zero(), -Vec3::UnitY(), 10, 10); }

SimulationSettings soft() {
    SimulationSettings out;
    out.material.young_modulus = 4e7;
    out.sag_free = false;
    out.damping = 0.02;
    return out;
}

TEST(SimulationAir, AThreadLeansIntoTheBalanceOfDragAndWeight) {
    SimulationSettings settings = soft();
    settings.drag = 2e-4;
    settings.wind.mean = {200, 0, 0};
    const Guides rest = thread();
    Simulation simulation(rest, settings, scene_of(rest), 1);
    for (int frame = 0; frame < 24 * 8; ++frame) simulation.advance();
    // The forces per centimetre are nu w across and rho S g down, so a thread without
    // stiffness is straight and leans by atan(nu w / rho S g). From the clamped root it
    // turns into that direction at a constant rate within the first segment, 1 cm, which
    // displaces the rest by half a centimetre times the lean at most.
    const RodSection section =
        rod_section(settings.material, settings.dissipation, settings.damping);
    const double lean = std::atan(2e-4 * 200 / (section.linear_density * 981));
    const Vec3 want = 10 * Vec3(std::sin(lean), -std::cos(lean), 0);
    EXPECT_GT(lean, 0.5);
    EXPECT_LT((tip_of(simulation.guides(), 0) - want).norm(), lean / 2);
}

TEST(SimulationAir, WithoutDragThereIsNoWind) {
    SimulationSettings still = soft(), windy = soft();
    still.drag = windy.drag = 0;
    windy.wind.mean = {500, 100, 0};
    const Guides rest = thread();
    const auto a = simulate(rest, still, scene_of(rest), 1, 6);
    const auto b = simulate(rest, windy, scene_of(rest), 1, 6);
    EXPECT_TRUE(same_bits(a.back(), b.back()));
}

TEST(SimulationAir, MoreDragDampsASwingSooner) {
    Guides rest = straight_guide(Vec3::Zero(), {1, -1, 0}, 10, 10);
    double before = 1e9;
    for (const double drag : {0., 2e-4, 2e-3}) {
        SimulationSettings settings = soft();
        settings.step.integrator = Integrator::bdf2;
        settings.drag = drag;
        settings.substeps = 8;
        double late = 0;
        const auto frames = simulate(rest, settings, scene_of(rest), 1, 73);
        for (std::size_t i = 48; i < frames.size(); ++i) {
            late = std::max(late, std::abs(tip_of(frames[i], 0).x()));
        }
        EXPECT_LT(late, 0.8 * before) << drag;
        before = late;
    }
}

TEST(SimulationAir, AThreadFallsAtItsTerminalVelocity) {
    // Released level: its end approaches the speed rho S g / nu, low for strong drag.
    SimulationSettings settings = soft();
    settings.drag = 4e-3;
    settings.substeps = 8;
    const RodSection section =
        rod_section(settings.material, settings.dissipation, settings.damping);
    const double terminal = section.linear_density * 981 / settings.drag;  // 16 cm/s
    const Guides rest = straight_guide(Vec3::Zero(), Vec3::UnitX(), 30, 12);
    const auto frames = simulate(rest, settings, scene_of(rest), 1, 13);
    const double fps = 24;
    for (std::size_t i = 6; i + 1 < frames.size(); ++i) {
        const double speed =
            (tip_of(frames[i], 0).y() - tip_of(frames[i + 1], 0).y()) * fps;
        // Inertia has decayed after rho S / nu = 0.016 s; after 0.25 s the tip is still
        // level and not yet held by the root: it falls freely, to a few per cent.
        EXPECT_NEAR(speed, terminal, 0.05 * terminal) << i;
    }
}

}  // namespace
}  // namespace lancret
