#pragma once
// Rods with length, EI and rho S of 1, for tests.

#include "sim/rod/energy.h"

namespace lancret {

/// Equal segments; gravity -z of strength `gamma`; n2 = n0 x n1.
inline HangingRod made_rod(int segments, double gamma, const Vec3& natural = Vec3::Zero(),
                           const Vec3& tangent = Vec3::UnitX(),
                           const Vec3& normal = Vec3::UnitZ(),
                           const Vec3& stiffness = Vec3(2. / 3, 1, 1)) {
    HangingRod rod;
    rod.root.frame << tangent, normal, tangent.cross(normal);
    rod.lengths.assign(segments, 1. / segments);
    rod.natural.assign(segments, natural);
    rod.section.stiffness = stiffness;
    rod.gravity = -gamma * Vec3::UnitZ();
    return rod;
}

/// Clamped like hanging hair: tangent -z, n1 = +x, n2 = -y.
inline HangingRod hanging_rod(int segments, double gamma,
                              const Vec3& natural = Vec3::Zero()) {
    return made_rod(segments, gamma, natural, -Vec3::UnitZ(), Vec3::UnitX());
}

inline Vec3 tip_of(const HangingRod& rod, const Eigen::VectorXd& q) {
    return rod_joints(rod, q).back().position;
}

}  // namespace lancret
