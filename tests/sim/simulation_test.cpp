#include "sim/simulation.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <stdexcept>

#include "tests/sim/small_scenes.h"

namespace lancret {
namespace {

TEST(Simulation, RootsAreThoseOfTheHeadAndLengthsStay) {
    const BusyScene busy;
    Simulation simulation = busy.simulation();
    const RigidPath path = make_rigid_path(busy.keys, Vec3::Zero(), 24);
    for (int frame = 1; frame <= 14; ++frame) {
        EXPECT_EQ(simulation.frame(), frame);
        const ScalpTime time = rigid_motion(path, frame);
        const Guides& now = simulation.guides();
        for (std::size_t g = 0; g < now.size(); ++g) {
            const RootMotion root = root_motion(time, {busy.guides.root(g), {}});
            EXPECT_LT((now.root_positions[g] - root.pose.position).norm(), 1e-12);
            EXPECT_LT((now.root_frames[g] - root.pose.frame).norm(), 1e-12);
        }
        EXPECT_EQ(now.segment_lengths, busy.guides.segment_lengths);
        simulation.advance();
    }
    const SimulationReport report = simulation.take_report();
    EXPECT_EQ(report.unsolved, 0u);
    EXPECT_GE(report.steps, 24u * 2 * 14);
    EXPECT_EQ(simulation.take_report().steps, 0u);  // reset by the call above
}

TEST(Simulation, SameBitsForAnyNumberOfThreads) {
    for (const bool strands : {false, true}) {
        BusyScene busy;
        if (!strands) busy.settings.strand_contact.radius = 0;
        const auto run = [&](std::size_t threads) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                            threads);
            Simulation simulation = busy.simulation();
            for (int frame = 0; frame < 10; ++frame) simulation.advance();
            return std::pair(simulation.guides(), simulation.restart());
        };
        const auto [one, arrays_one] = run(1);
        const auto [two, arrays_two] = run(2);
        EXPECT_TRUE(same_bits(one, two));
        EXPECT_EQ(arrays_one, arrays_two);
    }
}

/// The number of touching anchors: rows of 13 numbers, of which the second is the body.
int touching(const RestartArrays& arrays) {
    int out = 0;
    const std::vector<double>& rows = arrays.at("anchors");
    for (std::size_t i = 1; i < rows.size(); i += 13) out += rows[i] >= 0;
    return out;
}

TEST(Simulation, ContinuesFromAnyFrameWithTheSameBits) {
    for (const Integrator integrator : {Integrator::implicit_euler, Integrator::bdf2}) {
        const BusyScene busy(integrator);
        Simulation whole = busy.simulation();
        int anchors = 0, halved = 0;
        for (int frame = 1; frame < 10; ++frame) {
            Simulation parted = busy.simulation();
            parted.resume(frame, whole.guides(), whole.restart());
            EXPECT_TRUE(same_bits(parted.guides(), whole.guides()));
            whole.advance();
            parted.advance();
            EXPECT_TRUE(same_bits(parted.guides(), whole.guides())) << frame;
            EXPECT_EQ(parted.restart(), whole.restart()) << frame;
            EXPECT_EQ(parted.frame(), whole.frame());
            anchors = std::max(anchors, touching(whole.restart()));
            const RestartArrays arrays = whole.restart();
            for (const double level : arrays.at("halvings")) halved += level > 0;
        }
        // Otherwise the test would prove little.
        EXPECT_GE(anchors, 3);
        EXPECT_GT(halved, 10);
    }
}

TEST(Simulation, ResetReturnsToTheStartAndRepeats) {
    const BusyScene busy;
    Simulation simulation = busy.simulation();
    const Guides begun = simulation.guides();
    simulation.advance();
    simulation.advance();
    const Guides later = simulation.guides();
    EXPECT_GT(tip_distance(begun, later), 0.01);
    simulation.reset();
    EXPECT_EQ(simulation.frame(), 1);
    EXPECT_TRUE(same_bits(simulation.guides(), begun));
    for (const Vec3& rate : simulation.rates()) EXPECT_EQ(rate, Vec3::Zero());
    simulation.advance();
    simulation.advance();
    EXPECT_TRUE(same_bits(simulation.guides(), later));

    // From a state that was set; it is at rest.
    simulation.set_initial();
    simulation.advance();
    simulation.reset();
    EXPECT_EQ(simulation.frame(), 3);
    EXPECT_TRUE(same_bits(simulation.guides(), later));
}

TEST(Simulation, ANaturalShapeStaysWithoutLoad) {
    const Guides guides = hanging_groom(6, 6, 10);
    SimulationSettings settings;
    settings.sag_free = false;
    settings.gravity.setZero();
    settings.drag = 0;
    Simulation simulation(guides, settings, scene_of(guides), 1);
    // Bent and released: returns to the natural shape of the constructor.
    Guides bent = guides;
    for (Vec3& k : bent.curvatures) k += Vec3(0.02, 0.05, -0.03);
    const RestartArrays still = simulation.restart();
    simulation.resume(1, bent, still);
    simulation.advance();
    EXPECT_GT(tip_distance(bent, simulation.guides()), 0.01);
    // Bent and declared natural: stays to round-off, 1e-14 of the length per step.
    simulation.resume(1, bent, still);
    simulation.set_natural();
    EXPECT_TRUE(std::ranges::equal(simulation.natural(), bent.curvatures));
    for (int frame = 0; frame < 10; ++frame) simulation.advance();
    EXPECT_LT(tip_distance(bent, simulation.guides()), 1e-11);
}

TEST(Simulation, SimulateReturnsEveryFrameFromTheFirst) {
    const BusyScene busy;
    Simulation simulation = busy.simulation();
    SimulationScene scene = scene_of(busy.guides, busy.keys);
    add_head(scene);
    const auto frames = simulate(busy.guides, busy.settings, std::move(scene), 1, 4);
    ASSERT_EQ(frames.size(), 4u);
    for (const Guides& frame : frames) {
        EXPECT_TRUE(same_bits(frame, simulation.guides()));
        simulation.advance();
    }
    EXPECT_THROW(simulate(busy.guides, {}, scene_of(busy.guides), 2, 1),
                 std::invalid_argument);
}

TEST(Simulation, RejectsInvalidSettings) {
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    const Guides guides = hanging_groom(2, 3, 5);
    const auto refuses = [&](auto&& change) {
        SimulationSettings settings;
        change(settings);
        EXPECT_THROW(Simulation(guides, settings, scene_of(guides), 1),
                     std::invalid_argument);
    };
    using S = SimulationSettings;
    for (const double bad : {nan, inf, -1.}) {
        refuses([=](S& s) { s.material.young_modulus = bad; });
        refuses([=](S& s) { s.material.radius2 = bad; });
        refuses([=](S& s) { s.damping = bad; });
        refuses([=](S& s) { s.drag = bad; });
        refuses([=](S& s) { s.contact.thickness = bad; });
        refuses([=](S& s) { s.contact.stiffness = bad; });
        refuses([=](S& s) { s.contact.regularization = bad; });
        refuses([=](S& s) { s.contact.friction = bad; });
        refuses([=](S& s) { s.contact.free_root = bad; });
        refuses([=](S& s) { s.strand_contact.radius = bad; });
        refuses([=](S& s) { s.strand_contact.stiffness = bad; });
        refuses([=](S& s) { s.strand_contact.friction_along = bad; });
        refuses([=](S& s) { s.strand_contact.cohesion = bad; });
        refuses([=](S& s) { s.wind.turbulence = bad; });
        refuses([=](S& s) { s.gravity.y() = bad == -1 ? nan : bad; });
    }
    refuses([](S& s) { s.error_tolerance = 0; });
    refuses([=](S& s) { s.error_tolerance = nan; });
    refuses([](S& s) { s.substeps = 0; });
    refuses([](S& s) { s.substeps = 1001; });
    refuses([](S& s) { s.max_halvings = 21; });
    refuses([](S& s) { s.contact.stations = 0; });
    refuses([](S& s) { s.contact.stations = 33; });
    refuses([](S& s) { s.step.max_iterations = 0; });
    refuses([](S& s) { s.wind.mean.x() = 1e10; });

    const auto refuses_scene = [&](const Guides& rest, SimulationScene scene, double at) {
        EXPECT_THROW(Simulation(rest, {}, std::move(scene), at), std::invalid_argument);
    };
    refuses_scene(guides, scene_of(guides), nan);
    refuses_scene(guides, scene_of(guides), 1e12);
    refuses_scene({}, scene_of({}), 1);
    refuses_scene(guides, scene_of(hanging_groom(3, 3, 5)), 1);
    SimulationScene timeless = scene_of(guides);
    timeless.frames_per_second = 0;
    refuses_scene(guides, std::move(timeless), 1);
    Guides bad = guides;
    bad.curvatures[1].x() = nan;
    refuses_scene(bad, scene_of(guides), 1);
    bad = guides;
    bad.segment_lengths[2] = 0;
    refuses_scene(bad, scene_of(guides), 1);
    bad = guides;
    bad.curvatures.pop_back();
    refuses_scene(bad, scene_of(guides), 1);
}

}  // namespace
}  // namespace lancret
