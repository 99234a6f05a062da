#pragma once
// Energy and momentum of a rod, and the reaction of its root.

#include "sim/rod/rod.h"

namespace lancret {

/// Energies of a rod, erg.
struct RodEnergy {
    double kinetic = 0;
    double elastic = 0;
    double gravity = 0;  ///< zero at the origin

    double total() const { return kinetic + elastic + gravity; }
};

RodEnergy energy(const Rod& rod, const RodState& state, const Vec3& gravity);

/// Linear momentum, g cm/s, and angular momentum about the origin, g cm^2/s.
struct Momentum {
    Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
};

Momentum momentum(const Rod& rod, const RodState& state);

/// The force (dyn) and its moment about the root (dyn cm) with which the root holds the
/// rod while its curvatures accelerate by `accelerations`, [segments]: mass times
/// acceleration, less weight and drag in still air.
struct RootReaction {
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
};

RootReaction root_reaction(const Rod& rod, const RodState& state,
                           std::span<const Vec3> accelerations, const Vec3& gravity,
                           double drag);

}  // namespace lancret
