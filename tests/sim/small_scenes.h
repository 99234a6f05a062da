#pragma once
// Small grooms and scenes for the tests of Simulation.

#include <random>

#include "guides/helix/super_helix.h"
#include "sim/simulation.h"
#include "tests/sim/rod/rods.h"

namespace lancret {

/// The frame of a root whose tangent is `along` and whose normal n1 is near `up`.
inline Mat3 frame_along(const Vec3& along, const Vec3& up = Vec3::UnitZ()) {
    Mat3 out;
    const Vec3 t = along.normalized(), n = (up - t * t.dot(up)).normalized();
    out << t, n, t.cross(n);
    return out;
}

/// Adds a guide with segments of equal length.
inline void add_guide(Guides& guides, const Vec3& root, const Mat3& frame, double length,
                      const std::vector<Vec3>& curvatures) {
    guides.segments = int(curvatures.size());
    guides.root_positions.push_back(root);
    guides.root_frames.push_back(frame);
    for (const Vec3& k : curvatures) {
        guides.segment_lengths.push_back(length / guides.segments);
        guides.curvatures.push_back(k);
    }
}

/// A straight guide along `along`.
inline Guides straight_guide(const Vec3& root, const Vec3& along, double length,
                             int segments) {
    Guides out;
    add_guide(out, root, frame_along(along, Vec3(0.1, 0.3, 0.9)), length,
              std::vector<Vec3>(std::size_t(segments), Vec3::Zero()));
    return out;
}

/// Wavy guides all around the sphere of radius 8 about the origin: they stand out at the
/// roots and then hang down.
inline Guides hanging_groom(int count, int segments, double length, double curl = 0.4) {
    Guides out;
    std::mt19937_64 random(11);
    for (int g = 0; g < count; ++g) {
        const double turn = 2 * kPi * g / count;
        const Vec3 normal = Vec3(std::cos(turn), 0.4, std::sin(turn)).normalized();
        const Vec3 start = (normal + Vec3(0, 0.5, 0)).normalized();
        std::vector<Vec3> k;
        HelixState<double> at{frame_along(start), 8 * normal};
        for (int q = 0; q < segments; ++q) {
            // Bends towards a direction that is mostly down and a little outwards.
            const Vec3 way = q < 2 ? normal : Vec3(0.15 * normal - Vec3(0, 1, 0));
            const Vec3 t = at.frame.col(0);
            const Vec3 turned = t.cross(way.normalized());
            const double l = length / segments;
            Vec3 u = at.frame.transpose() * turned / l * 0.7;
            u += random_vector(random, curl);
            k.push_back(u);
            advance<double>(at, u, l);
        }
        add_guide(out, 8 * normal, frame_along(start), length, k);
    }
    return out;
}

/// A scene whose head moves by `keys`, or stands still without them.
inline SimulationScene scene_of(const Guides& guides, std::vector<PoseKey> keys = {}) {
    if (keys.empty()) keys.push_back({});
    SimulationScene out{make_rigid_path(keys, Vec3::Zero(), 24), {}, 24, {}, {}};
    for (std::size_t g = 0; g < guides.size(); ++g) {
        out.roots.push_back({guides.root(g), {}});
    }
    return out;
}

/// Adds the sphere of radius 8 as a head that moves with the scene.
inline void add_head(SimulationScene& scene) {
    const int index = scene.colliders.add(Capsule{Vec3::Zero(), Vec3::Zero(), 8});
    const RigidPath path = std::get<RigidPath>(scene.motion);
    scene.move_colliders = [path, index](double frame, Colliders& colliders) {
        colliders.move(index, rigid_motion(path, frame).pose);
    };
}

inline Vec3 tip_of(const Guides& guides, std::size_t g) {
    return state_at(super_helix(guides, g), guide_length(guides, g)).position;
}

/// The largest distance between the tips of two states of the same guides.
inline double tip_distance(const Guides& a, const Guides& b) {
    double out = 0;
    for (std::size_t g = 0; g < a.size(); ++g) {
        out = std::max(out, (tip_of(a, g) - tip_of(b, g)).norm());
    }
    return out;
}

inline bool same_bits(const Guides& a, const Guides& b) {
    return a.root_positions == b.root_positions && a.root_frames == b.root_frames &&
           a.segment_lengths == b.segment_lengths && a.curvatures == b.curvatures;
}

/// All features at once: a shaking head, contact with friction, contact between strands,
/// gusts, and steps that are halved.
struct BusyScene {
    Guides guides = hanging_groom(24, 6, 9);
    SimulationSettings settings;
    std::vector<PoseKey> keys{{1, {0, 0, 0}, {0, 0, 0}},
                              {5, {3, 1, 0}, {0, 70, 10}},
                              {9, {-3, 0, 2}, {10, -70, 0}},
                              {12, {0, 0, 0}, {0, 0, 0}}};

    explicit BusyScene(Integrator integrator = Integrator::implicit_euler) {
        settings.step.integrator = integrator;
        settings.wind.turbulence = 60;
        settings.wind.seed = 4;
        settings.strand_contact = {0.2, 20, 0.1, 0.05, 2};
        settings.error_tolerance = 0.02;
        settings.substeps = 2;
        settings.max_halvings = 3;
    }
    Simulation simulation() const {
        SimulationScene scene = scene_of(guides, keys);
        add_head(scene);
        return Simulation(guides, settings, std::move(scene), 1);
    }
};

}  // namespace lancret
