#include "sim/equilibrium/sag_free.h"

#include <gtest/gtest.h>

#include "sim/rod/energy.h"
#include "tests/sim/rod/rod_gradient.h"
#include "tests/sim/small_scenes.h"

namespace lancret {
namespace {

TEST(SagFree, TheGroomIsAnEquilibriumOfTheRodsEnergy) {
    const Guides guides = hanging_groom(12, 8, 15);
    RodMaterial hair;
    hair.radius2 = 0.007;
    const RodSection section = rod_section(hair, Dissipation::viscoelastic, 0.05);
    const Vec3 gravity(100, -981, 50);
    const std::vector<Vec3> natural = sag_free_natural(guides, section, gravity);
    for (std::size_t g = 0; g < guides.size(); ++g) {
        HangingRod rod;
        rod.root = guides.root(g);
        rod.lengths.assign(8, 15. / 8);
        rod.natural.assign(natural.begin() + long(g) * 8,
                           natural.begin() + long(g) * 8 + 8);
        rod.section = section;
        rod.gravity = gravity;
        Eigen::VectorXd q(24);
        for (int i = 0; i < 24; ++i) {
            q[i] = guides.curvatures_of(g)[std::size_t(i / 3)][i % 3];
        }
        // The load sets the scale; the two quadratures agree to 1e-10 each.
        GravityTerms load;
        gravity_terms(rod, q, Derivatives::first, load);
        EXPECT_GT(load.gradient.norm(), 0.1);
        EXPECT_LT(rod_gradient(rod, q).norm(), 1e-9 * load.gradient.norm());
    }
}

/// The largest distance of a tip from its rest position within a second.
double drift(const Guides& guides, SimulationSettings settings, bool head) {
    SimulationScene scene = scene_of(guides);
    if (head) add_head(scene);
    double out = 0;
    for (const Guides& frame : simulate(guides, settings, std::move(scene), 1, 25)) {
        out = std::max(out, tip_distance(guides, frame));
    }
    return out;
}

TEST(SagFree, TipsStayForASecond) {
    // At rest the residual of a step is round-off, 1e-14 of the weight, which moves a
    // hair of length L by 1e-14 L; 96 such steps add to 1e-11 cm. An unstable equilibrium
    // (hair bent upwards) multiplies that by exp(t sqrt(g / L)), at most 3000 for 15 cm
    // and one second.
    constexpr double kRoundOff = 3e-8;
    for (const double radius2 : {0.004, 0.009}) {
        for (const Integrator integrator :
             {Integrator::implicit_euler, Integrator::bdf2}) {
            SimulationSettings settings;
            settings.material.radius2 = radius2;
            settings.step.integrator = integrator;
            const Guides waves = hanging_groom(12, 8, 15);
            const Guides curls = hanging_groom(12, 8, 15, 2);
            for (const bool head : {false, true}) {
                EXPECT_LT(drift(waves, settings, head), kRoundOff);
                EXPECT_LT(drift(curls, settings, head), kRoundOff);
            }
            settings.sag_free = false;
            EXPECT_GT(drift(waves, settings, false), 0.1);  // without it the groom sags
        }
    }
}

TEST(SagFree, AGroomThatLiesInTheHeadIsNotPushed) {
    // Guides that bend into the head, with whole segments inside it.
    Guides guides;
    for (int g = 0; g < 6; ++g) {
        const Vec3 n = Vec3(std::cos(g), 0, std::sin(g));
        add_guide(guides, 8 * n, frame_along(n + Vec3(0, 1.5, 0), Vec3(0, 1, 0)), 8,
                  std::vector<Vec3>(6, Vec3(0, 0.1, 0.3 + 0.1 * g)));
    }
    SimulationScene scene = scene_of(guides);
    add_head(scene);
    double deepest = 0;
    for (std::size_t g = 0; g < guides.size(); ++g) {
        for (double s = 0; s < 8; s += 0.1) {
            const Vec3 x = state_at(super_helix(guides, g), s).position;
            deepest = std::max(deepest, -scene.colliders.nearest(x, 1).distance);
        }
    }
    ASSERT_GT(deepest, 0.5);
    EXPECT_LT(drift(guides, {}, true), 3e-8);
}

TEST(SagFree, FindsTheGuidesThatWouldFall) {
    // A straight upright hair buckles at rho S g L^3 / EI = 7.8373 (8 segments: 7.8745);
    // a hanging one never does.
    const RodSection section = rod_section({}, Dissipation::viscoelastic, 0);
    const double unit = section.stiffness.y() / (section.linear_density * 981);
    const Vec3 gravity(0, -981, 0), up = Vec3::UnitY();
    Guides guides;
    const std::vector<Vec3> straight(8, Vec3::Zero());
    for (const double gamma : {7.7, 8.0, 30.}) {
        add_guide(guides, Vec3::Zero(), frame_along(up), std::cbrt(gamma * unit),
                  straight);
    }
    add_guide(guides, Vec3::Zero(), frame_along(-up), std::cbrt(30 * unit), straight);
    const auto natural = sag_free_natural(guides, section, gravity);
    EXPECT_EQ(falling_guides(guides, natural, section, gravity),
              (std::vector<std::size_t>{1, 2}));
}

}  // namespace
}  // namespace lancret
