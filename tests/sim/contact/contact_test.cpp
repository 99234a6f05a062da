#include "sim/contact/contact.h"

#include <gtest/gtest.h>

#include "guides/helix/super_helix.h"
#include "sim/segment/gauss_legendre.h"
#include "tests/guides/base/finite_difference.h"
#include "tests/guides/bodies/box_mesh.h"
#include "tests/sim/rod/rods.h"

namespace lancret {
namespace {

TEST(Penalty, IsBergbomsForceAndTheDerivativeOfItsEnergy) {
    // [Bergbom07, Sec. 4.2.10]: k d^2 / (2 reg) up to reg, k (d - reg / 2) beyond.
    const double k = 700, reg = 0.03;
    EXPECT_EQ(penalty(0, k, reg).force, 0);
    EXPECT_EQ(penalty(-1, k, reg).energy, 0);
    EXPECT_DOUBLE_EQ(penalty(0.01, k, reg).force, k * 0.01 * 0.01 / (2 * reg));
    EXPECT_DOUBLE_EQ(penalty(0.5, k, reg).force, k * (0.5 - reg / 2));
    for (const double d : {0.004, 0.02, 0.029, 0.031, 0.1, 3.}) {
        const auto value = [&](double x) {
            const Penalty p = penalty(x, k, reg);
            return Vec3(p.energy, p.force, 0);
        };
        const Vec3 slope = finite_difference(value, d, 1e-4);
        const Penalty p = penalty(d, k, reg);
        // Polynomials of degree at most 3: the only error is round-off, 3e-16 of the
        // value divided by the step.
        EXPECT_NEAR(slope[0], p.force, 1e-11 * (1 + value(d)[0]) * k) << d;
        EXPECT_NEAR(slope[1], p.stiffness, 1e-11 * (1 + value(d)[1]) * k) << d;
    }
    // The pieces meet without a jump.
    const Penalty below = penalty(reg, k, reg),
                  above = penalty(reg * (1 + 1e-15), k, reg);
    EXPECT_NEAR(below.energy, above.energy, 1e-12 * below.energy);
    EXPECT_NEAR(below.force, above.force, 1e-12 * below.force);
    EXPECT_NEAR(below.stiffness, above.stiffness, 1e-12 * below.stiffness);
}

/// A rod of four segments with all inputs of its contact.
struct Touching {
    TestRod rod;
    Colliders colliders;
    ContactSettings settings;
    StrandContactSettings strands;
    std::vector<ContactAnchor> anchors;
    std::vector<double> allowed;
    std::vector<Vec3> positions;
    std::vector<StrandNear> near;
    std::vector<std::uint8_t> counts;

    explicit Touching(int seed) {
        std::mt19937_64 random(seed);
        rod = random_rod(4, 0.5, random);
        rod.root.pose.position.setZero();
        settings.free_root = 0.1;
        settings.thickness = 0.1;
        const GaussRule rule = gauss_rule(settings.stations);
        double start = 0;
        std::vector<double> s;
        for (const double l : rod.lengths) {
            for (const double node : rule.nodes) s.push_back(start + node * l);
            start += l;
        }
        anchors.resize(s.size());
        allowed.assign(s.size(), 0);
        sample(SuperHelix{rod.root.pose, rod.lengths, rod.curvatures}, s,
               [&](std::size_t, auto, const auto& state) {
                   positions.push_back(state.position);
               });
    }

    /// The energy of the contact at `q`, and its generalised force.
    double energy(const std::vector<Vec3>& q, std::vector<Vec3>* force = nullptr) {
        PointLayout layout;
        layout.lay_out(rod.lengths, q);
        PointVectors targets;
        std::vector<Vec3> joints;
        point_positions(rod.lengths, rod.root.pose, q, layout, targets, joints);
        RodSystem system;  // with springs of strength 0
        system.linearize(rod.root.pose, rod.lengths, q, layout, targets, 0);
        std::vector<ContactAnchor> kept = anchors;
        RodContact contact(colliders, settings, strands);
        contact.begin({rod.lengths, kept, allowed, positions, near, counts, {}}, 0.01);
        const double out = contact.add_to(system, 1);
        if (force) {
            force->resize(q.size());
            system.forces(*force);
        }
        return out;
    }

    /// Expects that the force is minus the slope of the energy along random directions.
    /// The penalty's third derivative jumps, with an error of at most k h^2 / (6 reg) for
    /// a station within h of a jump: 1e-6 here. Round-off is 1e-15 of the energy over h.
    void expect_force_is_slope(double min_energy) {
        std::vector<Vec3> force;
        const double here = energy(rod.curvatures, &force);
        EXPECT_GT(here, min_energy);
        std::mt19937_64 random(3);
        for (int round = 0; round < 8; ++round) {
            std::vector<Vec3> way;
            double want = 0;
            for (const Vec3& f : force) {
                way.push_back(random_vector(random, 1));
                want -= f.dot(way.back());
            }
            const auto value = [&](double x) {
                std::vector<Vec3> q = rod.curvatures;
                for (std::size_t i = 0; i < q.size(); ++i) q[i] += x * way[i];
                return Eigen::Matrix<double, 1, 1>(energy(q));
            };
            const double slope = finite_difference(value, 0, 1e-5)[0];
            EXPECT_NEAR(slope, want, 2e-6 + 1e-7 * std::abs(want) + 1e-9 * here);
        }
    }
};

/// Gives each station an anchor at its depth, displaced by up to `slide`.
void hold(Touching& t, double slide, double pressure) {
    std::mt19937_64 random(9);
    for (std::size_t i = 0; i < t.anchors.size(); ++i) {
        ContactAnchor& anchor = t.anchors[i];
        anchor.body = t.colliders.nearest(t.positions[i], 10);
        const Vec3 n = anchor.body.normal, x = random_vector(random, slide);
        anchor.position = t.positions[i] + x - n * n.dot(x);
        anchor.pressure = pressure;
    }
}

TEST(RodContact, ForceOnABodyIsTheSlopeOfItsEnergy) {
    for (int seed = 0; seed < 6; ++seed) {
        Touching sphere(seed), box(seed);
        const Vec3 tip = sphere.positions.back();
        const Vec3 centre = tip + Vec3(0.3, 0.2, 0.1);  // not at a station
        sphere.colliders.add(Capsule{centre, centre, 0.6});
        box.colliders.add(box_mesh({9, 9, 9}), {Mat3::Identity(), tip - Vec3(9, 0, 0)});
        for (Touching* t : {&sphere, &box}) {
            SCOPED_TRACE(t == &box ? "box" : "sphere");
            t->expect_force_is_slope(0.1);
            // First stick, with springs well within the friction limit; then slip.
            hold(*t, 0.001, 100);
            t->expect_force_is_slope(0.1);
            hold(*t, 0.2, 2);
            t->expect_force_is_slope(0.1);
        }
    }
}

TEST(RodContact, InitialDepthDoesNotPush) {
    Touching t(1);
    t.colliders.add(Capsule{t.positions.back(), t.positions.back(), 0.6});
    for (std::size_t i = 0; i < t.positions.size(); ++i) {
        t.allowed[i] = std::max(
            0., t.settings.thickness - t.colliders.nearest(t.positions[i], 1).distance);
    }
    EXPECT_LT(t.energy(t.rod.curvatures), 1e-30);
    // Where the strand goes deeper, it is pushed.
    t.rod.root.pose.position = t.positions.back() - t.positions[12];
    EXPECT_GT(t.energy(t.rod.curvatures), 1e-3);
}

TEST(RodContact, ForceBetweenStrandsIsTheSlopeOfItsEnergy) {
    for (int seed = 0; seed < 6; ++seed) {
        Touching t(seed);
        t.strands = {0.1, 20, 0.3, 0.02, 5};
        std::mt19937_64 random(seed);
        t.near.resize(t.positions.size() * RodContact::kMaxNear);
        t.counts.assign(t.positions.size(), 3);
        for (std::size_t i = 0; i < t.near.size(); ++i) {
            // Distances from touching to beyond the well of cohesion.
            const Vec3 way = random_vector(random, 1).normalized();
            const double away = 0.02 + 0.45 * double(i % 17) / 17;
            t.near[i] = {t.positions[i / RodContact::kMaxNear] + away * way,
                         random_vector(random, 0.05), way.unitOrthogonal(), 0.5};
        }
        for (Vec3& x : t.positions) x += random_vector(random, 0.03);
        t.expect_force_is_slope(1e-3);
    }
}

TEST(RodContact, CohesionEnergyRisesAndThenStaysConstant) {
    Touching t(2);
    t.strands = {0.1, 20, 0, 0, 5};
    t.near.resize(t.positions.size() * RodContact::kMaxNear);
    t.counts.assign(t.positions.size(), 0);
    t.counts[7] = 1;
    double before = -1;
    for (double away = 0.2; away < 0.5; away += 0.001) {
        t.near[7 * RodContact::kMaxNear] = {t.positions[7] + Vec3(0, 0, away),
                                            Vec3::Zero(), Vec3::UnitX(), 1};
        const double now = t.energy(t.rod.curvatures);
        // Rises to the edge of the well, then stays constant.
        EXPECT_GE(now, before - 1e-15) << away;
        if (away > 0.401) {
            EXPECT_NEAR(now, before, 1e-15) << away;
        }
        before = now;
    }
    EXPECT_GT(before, 0);
}

TEST(RodContact, AnAnchorIsDraggedNoFurtherThanFrictionHolds) {
    Touching t(4);
    const Vec3 tip = t.positions.back();
    t.colliders.add(box_mesh({9, 9, 9}), {Mat3::Identity(), tip - Vec3(0, 0, 9 - 0.02)});
    PointLayout layout;
    layout.lay_out(t.rod.lengths, t.rod.curvatures);
    PointVectors targets;
    std::vector<Vec3> joints;
    point_positions(t.rod.lengths, t.rod.root.pose, t.rod.curvatures, layout, targets,
                    joints);
    RodSystem system;
    system.linearize(t.rod.root.pose, t.rod.lengths, t.rod.curvatures, layout, targets,
                     1);
    RodContact contact(t.colliders, t.settings, t.strands);
    contact.begin({t.rod.lengths, t.anchors, t.allowed, {}, {}, {}, {}}, 0.01);
    contact.end(system);
    ContactAnchor& last = t.anchors.back();
    ASSERT_TRUE(last.touches());
    EXPECT_LT((last.position - tip).norm(), 1e-12);  // a new anchor has no slide
    // Moved 1 cm away: it follows to mu p / k, in the plane of the surface.
    last.position += Vec3(0.6, 0.8, 0.3);
    contact.end(system);
    EXPECT_NEAR(last.position.z(), tip.z(), 1e-12);
    EXPECT_NEAR((last.position - tip).norm(),
                t.settings.friction * last.pressure / t.settings.stiffness, 1e-12);
    // Depth 0.12: a thickness of 0.1 and 0.02 cm below the surface; the box is in float.
    EXPECT_NEAR(last.pressure, t.settings.stiffness * (0.12 - 0.01), 1e-2);
}

TEST(RodContact, ClearancesDoNotChangeResults) {
    // A strand that swings past a turning box and a ball that comes and goes, with
    // queries at every step or only if something may have come near.
    for (const bool open : {false, true}) {
        Touching t(2);
        const Vec3 tip = t.positions.back();
        TriangleMesh box = box_mesh({0.4, 0.4, 0.4});
        if (open) box.triangles.resize(box.triangles.size() - 2);  // one side is missing
        t.colliders.add(box, {Mat3::Identity(), tip});
        t.colliders.add(Capsule{Vec3::Zero(), Vec3::Zero(), 0.2});
        std::vector<Clearance> clearances(t.positions.size());
        int touched = 0, skipped = 0;
        for (int step = 0; step < 200; ++step) {
            const double time = 0.05 * step;
            const Mat3 turn = helix_step<double>(Vec3(0, 0.3, 1), 0.4 * time).rotation;
            t.colliders.move(0, {turn, tip + Vec3(0.5 * std::sin(time), 0, 0)});
            t.colliders.move(1, {Mat3::Identity(), tip + Vec3(0, 3 * std::cos(time), 0)});
            for (Vec3& k : t.rod.curvatures) {
                k += Vec3(0, 0.02, -0.01) * std::cos(2 * time);
            }
            double energies[2];
            for (const bool remember : {false, true}) {
                PointLayout layout;
                layout.lay_out(t.rod.lengths, t.rod.curvatures);
                PointVectors targets;
                std::vector<Vec3> joints;
                point_positions(t.rod.lengths, t.rod.root.pose, t.rod.curvatures, layout,
                                targets, joints);
                RodSystem system;
                system.linearize(t.rod.root.pose, t.rod.lengths, t.rod.curvatures, layout,
                                 targets, 0);
                RodContact contact(t.colliders, t.settings, t.strands);
                RodContact::Strand strand{
                    t.rod.lengths, t.anchors, t.allowed, {}, {}, {}, {}};
                if (remember) {
                    strand.clearances = clearances;
                    const double drift = t.colliders.drift();
                    for (Clearance& c : clearances) skipped += (c.distance -= drift) > 0;
                }
                contact.begin(strand, 0.01);
                energies[remember] = contact.add_to(system, 1);
            }
            ASSERT_EQ(energies[0], energies[1]) << step;
            touched += energies[0] > 0;
        }
        EXPECT_GT(touched, 20);
        EXPECT_GT(skipped, open ? -1 : 200);
    }
}

}  // namespace
}  // namespace lancret
