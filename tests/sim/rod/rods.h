#pragma once
// Rods for tests.

#include <random>
#include <vector>

#include "sim/rod/rod.h"

namespace lancret {

/// Owns the arrays of a Rod and a RodState.
struct TestRod {
    std::vector<double> lengths;
    std::vector<Vec3> natural, curvatures, rates;
    RodSection section;
    RootMotion root;

    Rod rod() const { return {lengths, natural, section}; }
    RodState state() const { return {root, curvatures, rates}; }
    double length() const {
        double sum = 0;
        for (const double l : lengths) sum += l;
        return sum;
    }
};

/// A straight rod along x without motion: n segments, length 1, all constants 1.
inline TestRod straight_rod(int segments) {
    TestRod out;
    out.lengths.assign(segments, 1. / segments);
    out.natural.assign(segments, Vec3::Zero());
    out.curvatures = out.rates = out.natural;
    return out;
}

inline Vec3 random_vector(std::mt19937_64& random, double size) {
    std::uniform_real_distribution<double> uniform(-size, size);
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    return {x, y, z};
}

/// A moving rod of length 1 whose segments turn by up to about `turn` each, with a moving
/// root.
inline TestRod random_rod(int segments, double turn, std::mt19937_64& random) {
    TestRod out = straight_rod(segments);
    std::uniform_real_distribution<double> uniform(0.5, 1.5);
    double sum = 0;
    for (double& l : out.lengths) sum += l = uniform(random);
    for (double& l : out.lengths) l /= sum;
    for (int q = 0; q < segments; ++q) {
        out.curvatures[q] = random_vector(random, turn / out.lengths[q]);
        out.natural[q] = random_vector(random, turn / out.lengths[q]);
        out.rates[q] = random_vector(random, 3);
    }
    out.root.pose.frame = helix_step<double>(random_vector(random, 3), 1).rotation;
    out.root.pose.position = random_vector(random, 1);
    out.root.velocity = random_vector(random, 1);
    out.root.angular_velocity = random_vector(random, 2);
    out.root.acceleration = random_vector(random, 3);
    out.root.angular_acceleration = random_vector(random, 4);
    out.section.stiffness = {0.7, 1, 1.4};
    return out;
}

}  // namespace lancret
