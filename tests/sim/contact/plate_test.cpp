// A strand on a plate: its depth under its weight, and the friction cone.

#include <gtest/gtest.h>

#include "tests/guides/bodies/box_mesh.h"
#include "tests/sim/small_scenes.h"

namespace lancret {
namespace {

constexpr double kHalf = 20;  // of the plate's box, cm

/// A hair of 12 cm along x, clamped where it just touches a plate below it. The plate is
/// level and gravity is tilted by `slope` towards y, which is equivalent to a slope.
/// `big_ball`: instead of the plate, a ball that is flat to 0.001 cm under the hair.
struct Plate {
    SimulationSettings settings;
    Guides guides;
    bool ball;

    explicit Plate(double slope, bool big_ball = false) : ball(big_ball) {
        settings.sag_free = false;
        settings.material.young_modulus = 4e9;
        settings.gravity = 981 * Vec3(0, std::sin(slope), -std::cos(slope));
        settings.contact.free_root = 0;
        guides =
            straight_guide({0, 0, settings.contact.thickness}, Vec3::UnitX(), 12, 10);
    }
    Simulation simulation() const {
        SimulationScene scene = scene_of(guides);
        if (ball) {
            scene.colliders.add(Capsule{{6, 0, -1e5}, {6, 0, -1e5}, 1e5});
        } else {
            scene.colliders.add(box_mesh(Vec3f(kHalf, kHalf, kHalf)),
                                {Mat3::Identity(), {0, 0, -kHalf}});
        }
        return Simulation(guides, settings, std::move(scene), 1);
    }
    double weight() const {
        return rod_section(settings.material, settings.dissipation, settings.damping)
                   .linear_density *
               settings.gravity.norm();
    }
};

void run(Simulation& simulation, double seconds) {
    for (int frame = 0; frame < 24 * seconds; ++frame) simulation.advance();
}

TEST(Plate, AStrandLiesWherePenaltyBearsItsWeight) {
    const Plate plate(0);
    Simulation simulation = plate.simulation();
    run(simulation, 4);
    // k d^2 / (2 reg) = rho S g per centimetre. On springs of stiffness k d / reg the
    // effect of the clamp decays as exp(-s / 0.45 cm), and the free end is straight.
    const ContactSettings& c = plate.settings.contact;
    const double depth = std::sqrt(2 * c.regularization * plate.weight() / c.stiffness);
    ASSERT_LT(depth, c.regularization);
    for (const double s : {8., 10., 12.}) {
        const Vec3 x = state_at(super_helix(simulation.guides(), 0), s).position;
        EXPECT_NEAR(c.thickness - x.z(), depth, 0.01 * depth) << s;
    }
    EXPECT_EQ(simulation.take_report().deepest, 0);
}

TEST(Plate, SticksBelowTheAngleOfFrictionWithoutCreep) {
    for (const bool ball : {false, true}) {
        Plate plate(0, ball);
        const double mu = plate.settings.contact.friction;
        plate = Plate(std::atan(0.8 * mu), ball);
        Simulation simulation = plate.simulation();
        run(simulation, 2);
        const Vec3 settled = tip_of(simulation.guides(), 0);
        // The friction springs are stretched by 0.8 mu p / k = 1e-5 cm. In the first
        // frames, until the strand has sunk in and presses, it slides a little.
        EXPECT_LT(std::abs(settled.y()), 0.5);
        run(simulation, 5);
        // Round-off per step, 1e-14 of the length, and residual oscillation. Creep of
        // even a tenth of the stretch per step would add to 480 times 1e-6.
        EXPECT_LT((tip_of(simulation.guides(), 0) - settled).norm(), 1e-6);
    }
}

TEST(Plate, SlidesAboveTheAngleOfFriction) {
    for (const bool ball : {false, true}) {
        Plate plate(0, ball);
        const double mu = plate.settings.contact.friction;
        plate = Plate(std::atan(1.5 * mu), ball);
        Simulation simulation = plate.simulation();
        run(simulation, 6);
        // A cantilever under the load in excess of friction, w = (sin - mu cos) rho S g,
        // bends by w L^4 / (8 EI): 18 cm here, in any case more than a quarter of its
        // length.
        EXPECT_GT(tip_of(simulation.guides(), 0).y(), 3);
    }
}

TEST(Plate, WithoutFrictionASmallSlopeMovesIt) {
    Plate plate(0.02);
    plate.settings.contact.friction = 0;
    Simulation simulation = plate.simulation();
    run(simulation, 4);
    // w L^4 / (8 EI) = 2.6 cm with w = 0.02 rho S g.
    EXPECT_GT(tip_of(simulation.guides(), 0).y(), 1);
}

TEST(Plate, AMovingPlateTakesTheStrandAlong) {
    Plate plate(0);
    plate.settings.contact.friction = 1;
    SimulationScene scene = scene_of(plate.guides);
    const int index = scene.colliders.add(box_mesh(Vec3f(kHalf, kHalf, kHalf)));
    // Still for two seconds, then 1 cm/s towards y for one.
    scene.move_colliders = [index](double frame, Colliders& colliders) {
        const double y = std::clamp((frame - 49) / 24, 0., 1.);
        colliders.move(index, {Mat3::Identity(), {0, y, -kHalf}});
    };
    Simulation simulation(plate.guides, plate.settings, std::move(scene), 1);
    run(simulation, 2);
    const double before = tip_of(simulation.guides(), 0).y();
    run(simulation, 2);
    // Far from the clamp friction is much stronger than bending: the strand follows all
    // the way except for the springs' stretch, at most mu p / k = 6e-5 cm, and a turn of
    // the tip.
    EXPECT_NEAR(tip_of(simulation.guides(), 0).y() - before, 1, 0.02);
}

}  // namespace
}  // namespace lancret
