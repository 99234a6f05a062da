#include "tests/sim/rod/motion.h"

#include "sim/rod/points.h"
#include "sim/segment/gauss_legendre.h"

namespace lancret {

namespace {

/// Calls visit(point, mass) for each quadrature point of a rod.
template <class Visit>
void for_each_point(const Rod& rod, const PointLayout& layout, Visit&& visit) {
    for (int q = 0; q < rod.segments(); ++q) {
        const GaussRule rule = gauss_rule(layout.points(q));
        for (int i = 0; i < layout.points(q); ++i) {
            visit(layout.first(q) + i,
                  rod.section.linear_density * rod.lengths[q] * rule.weights[i]);
        }
    }
}

struct PointMotion {
    PointLayout layout;
    PointVectors positions, velocities;
    std::vector<Vec3> joints;

    PointMotion(const Rod& rod, const RodState& state) {
        layout.lay_out(rod.lengths, state.curvatures);
        point_positions(rod.lengths, state.root.pose, state.curvatures, layout, positions,
                        joints);
        point_velocities(rod, state, layout, velocities, joints);
    }
};

}  // namespace

RodEnergy energy(const Rod& rod, const RodState& state, const Vec3& gravity) {
    const PointMotion motion(rod, state);
    RodEnergy out;
    for_each_point(rod, motion.layout, [&](int i, double mass) {
        out.kinetic += mass * motion.velocities.get(i).squaredNorm() / 2;
        out.gravity -= mass * gravity.dot(motion.positions.get(i));
    });
    for (int q = 0; q < rod.segments(); ++q) {
        const Vec3 away = state.curvatures[q] - rod.natural[q];
        out.elastic += rod.lengths[q] / 2 * away.cwiseAbs2().dot(rod.section.stiffness);
    }
    return out;
}

Momentum momentum(const Rod& rod, const RodState& state) {
    const PointMotion motion(rod, state);
    Momentum out;
    for_each_point(rod, motion.layout, [&](int i, double mass) {
        const Vec3 p = mass * motion.velocities.get(i);
        out.linear += p;
        out.angular += motion.positions.get(i).cross(p);
    });
    return out;
}

RootReaction root_reaction(const Rod& rod, const RodState& state,
                           std::span<const Vec3> accelerations, const Vec3& gravity,
                           double drag) {
    const PointMotion motion(rod, state);
    PointVectors bias, driven;
    std::vector<Vec3> joints;
    point_bias(rod, state, motion.layout, bias);
    // J q'' is the velocity of a rod with rates q'' whose root stands still.
    RodState still = state;
    still.root = {state.root.pose};
    still.rates = accelerations;
    point_velocities(rod, still, motion.layout, driven, joints);
    RootReaction out;
    for_each_point(rod, motion.layout, [&](int i, double mass) {
        const Vec3 force =
            mass * (bias.get(i) + driven.get(i) - gravity +
                    drag / rod.section.linear_density * motion.velocities.get(i));
        out.force += force;
        out.moment += (motion.positions.get(i) - state.root.pose.position).cross(force);
    });
    return out;
}

}  // namespace lancret
