#include "sim/contact/strand_contact.h"

#include <gtest/gtest.h>

#include "tests/sim/small_scenes.h"

namespace lancret {
namespace {

/// Two hairs of 10 cm, one above the other, that cross at their middles without touching;
/// each is held at one end.
Guides crossing(double gap) {
    Guides out;
    const std::vector<Vec3> straight(10, Vec3::Zero());
    add_guide(out, {-5, 0, gap / 2}, frame_along({1, 0, 0}), 10, straight);
    add_guide(out, {0, -5, -gap / 2}, frame_along({0, 1, 0}), 10, straight);
    return out;
}

/// The smallest distance between two guides.
double distance(const Guides& guides) {
    double out = 1e9;
    for (double s = 0; s <= 10; s += 0.05) {
        const Vec3 a = state_at(super_helix(guides, 0), s).position;
        for (double t = 0; t <= 10; t += 0.05) {
            out =
                std::min(out, (a - state_at(super_helix(guides, 1), t).position).norm());
        }
    }
    return out;
}

/// The smallest distance over the frames in which the upper hair falls onto the lower.
double closest(double radius) {
    const Guides guides = crossing(0.6);
    SimulationSettings settings;
    settings.strand_contact.radius = radius;
    settings.strand_contact.stiffness = 200;
    settings.gravity.setZero();
    settings.sag_free = false;
    settings.substeps = 8;
    settings.contact.stations = 8;
    // The upper hair's natural curvature bends it down through the lower one.
    Simulation simulation(guides, settings, scene_of(guides), 1);
    RestartArrays arrays = simulation.restart();
    for (std::size_t q = 0; q < 10; ++q) arrays.at("natural")[3 * q + 2] = -0.06;
    simulation.resume(1, guides, arrays);
    double out = 1e9;
    bool crossed = false;
    for (int frame = 0; frame < 24; ++frame) {
        simulation.advance();
        out = std::min(out, distance(simulation.guides()));
        const Vec3 a = state_at(super_helix(simulation.guides(), 0), 5).position;
        const Vec3 b = state_at(super_helix(simulation.guides(), 1), 5).position;
        crossed |= a.z() < b.z();
    }
    EXPECT_EQ(crossed, radius == 0);
    return out;
}

TEST(StrandContact, KeepsCrossingStrandsApart) {
    closest(0);
    // Strands push each other from 2 radii on. The force of the natural bend,
    // EI 0.06 / 5 cm = 0.1 dyn over one to two stations, is a small part of the penalty's
    // 200 dyn/cm^2 times half of 0.2 cm times a station's 0.1 cm.
    EXPECT_GT(closest(0.1), 0.1);
}

/// rho S int v ds of both hairs, from differences of positions over a frame.
Vec3 momentum(const Guides& before, const Guides& now, std::size_t g, double density) {
    Vec3 sum = Vec3::Zero();
    for (double s = 0.05; s < 10; s += 0.1) {
        sum += density * 0.1 * 24 *
               (state_at(super_helix(now, g), s).position -
                state_at(super_helix(before, g), s).position);
    }
    return sum;
}

TEST(StrandContact, PairsOfStationsPushEachOtherEqually) {
    // Two hairs that are mirror images of each other move apart by the same distance.
    Guides guides;
    const std::vector<Vec3> straight(10, Vec3::Zero());
    Mat3 mirrored = frame_along({1, 0, 0});
    add_guide(guides, {0, 0.05, 0}, mirrored, 10, straight);
    add_guide(guides, {0, -0.05, 0}, mirrored, 10, straight);
    SimulationSettings settings;
    settings.gravity.setZero();
    settings.drag = 0;
    settings.strand_contact.radius = 0.1;
    const Guides begun = guides;
    Simulation simulation(guides, settings, scene_of(guides), 1);
    simulation.advance();
    const double density =
        rod_section(settings.material, settings.dissipation, settings.damping)
            .linear_density;
    const Vec3 a = momentum(begun, simulation.guides(), 0, density);
    const Vec3 b = momentum(begun, simulation.guides(), 1, density);
    EXPECT_GT(a.y(), 1e-4);
    // Along the hairs both tips move towards their roots, which hold them.
    EXPECT_NEAR(a.y(), -b.y(), 1e-9 * a.y());
    EXPECT_NEAR(a.x(), b.x(), 1e-9 * a.y());
}

TEST(StrandContact, NeighboursAreExtrapolatedWithTheirVelocities) {
    const Guides guides = crossing(0.1);
    std::vector<RodPast> pasts(2);
    StrandNeighbours neighbours;
    neighbours.find(guides, pasts, 0.3, 4, 0.01);
    // The second hair was 0.02 cm lower 0.02 s ago: it will move half of that in 0.01 s.
    const auto q = guides.curvatures_of(1);
    HelixState<double> lower = guides.root(1);
    lower.position.z() -= 0.02;
    pasts[1].push(lower, q, 0.02);
    StrandNeighbours moving;
    moving.find(guides, pasts, 0.3, 4, 0.01);
    int found = 0;
    for (std::size_t i = 0; i < 40; ++i) {
        ASSERT_EQ(neighbours.counts(0)[i], moving.counts(0)[i]);
        if (neighbours.counts(0)[i] == 0) continue;
        ++found;
        const StrandNear& still = neighbours.near(0)[i * RodContact::kMaxNear];
        const StrandNear& now = moving.near(0)[i * RodContact::kMaxNear];
        EXPECT_LT((now.displacement - Vec3(0, 0, 0.01)).norm(), 1e-14);
        EXPECT_LT((now.position - still.position - now.displacement).norm(), 1e-14);
        EXPECT_LT((now.tangent - Vec3(0, 1, 0)).norm(), 1e-14);
        EXPECT_EQ(now.share, 0.5);
    }
    EXPECT_GT(found, 0);
}

}  // namespace
}  // namespace lancret
