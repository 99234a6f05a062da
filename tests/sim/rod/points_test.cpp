#include "sim/rod/points.h"

#include <gtest/gtest.h>

#include "guides/helix/super_helix.h"
#include "sim/segment/gauss_legendre.h"
#include "tests/sim/rod/rods.h"

namespace lancret {
namespace {

/// The rod at time t: the curvatures change uniformly, the root follows its derivatives
/// (a rotation of constant angular acceleration as its series to third order).
TestRod at_time(const TestRod& rod, double t) {
    TestRod out = rod;
    for (std::size_t q = 0; q < rod.lengths.size(); ++q) {
        out.curvatures[q] += t * rod.rates[q];
    }
    const RootMotion& root = rod.root;
    out.root.pose.position += t * root.velocity + 0.5 * t * t * root.acceleration;
    // d/dt of the rotation vector from t = 0 is omega to first order and its derivative
    // alpha, since the vector and omega are parallel to first order.
    const Vec3 turn = t * root.angular_velocity + 0.5 * t * t * root.angular_acceleration;
    out.root.pose.frame = helix_step<double>(turn, 1).rotation * root.pose.frame;
    return out;
}

std::vector<Vec3> positions_of(const TestRod& rod, const PointLayout& layout) {
    std::vector<Vec3> out;
    const SuperHelix helix{rod.root.pose, rod.lengths, rod.curvatures};
    double start = 0;
    for (int q = 0; q < layout.segments(); ++q) {
        for (const double node : gauss_rule(layout.points(q)).nodes) {
            out.push_back(state_at(helix, start + node * rod.lengths[q]).position);
        }
        start += rod.lengths[q];
    }
    return out;
}

TEST(RodPoints, MotionAndBiasMatchFiniteDifferences) {
    std::mt19937_64 random(1);
    for (const double turn : {0., 1e-6, 0.3, 2., 9.}) {
        const TestRod rod = random_rod(5, turn, random);
        PointLayout layout;
        layout.lay_out(rod.lengths, rod.curvatures);
        PointVectors positions, velocities, bias;
        std::vector<Vec3> joints, joint_velocities;
        point_positions(rod.lengths, rod.root.pose, rod.curvatures, layout, positions,
                        joints);
        point_velocities(rod.rod(), rod.state(), layout, velocities, joint_velocities);
        point_bias(rod.rod(), rod.state(), layout, bias);
        // Central differences: h^2 r''' / 6 and h^2 r'''' / 12 against eps / h and
        // 4 eps / h^2: about 1e-7 for second ones at h = 1e-4 (derivatives of order 100).
        constexpr double h = 1e-4;
        const auto now = positions_of(rod, layout),
                   up = positions_of(at_time(rod, h), layout),
                   down = positions_of(at_time(rod, -h), layout);
        for (int i = 0; i < layout.size(); ++i) {
            EXPECT_LT((positions.get(i) - now[i]).norm(), 1e-14);
            EXPECT_LT((velocities.get(i) - (up[i] - down[i]) / (2 * h)).norm(), 1e-6);
            EXPECT_LT((bias.get(i) - (up[i] - 2 * now[i] + down[i]) / (h * h)).norm(),
                      1e-5 * (1 + bias.get(i).norm()));
        }
    }
}

}  // namespace
}  // namespace lancret
