#pragma once
// What is read off a hanging rod: its ends, its lowest point, the curvature at its root.

#include "sim/rod/energy.h"

namespace lancret {

struct LowestPoint {
    double height = 0;  ///< along `up`, cm
    double s = 0;       ///< arc length, cm
};

/// The lowest point along the unit vector `up`, on the curve and not only at its joints.
LowestPoint lowest_point(const HangingRod& rod, const Eigen::VectorXd& q, const Vec3& up);

/// The Darboux vector at s = 0, 1/cm, from the balance of moments: the natural one + K^-1
/// times the weight's moment about the root, in the root's frame. Of second order in the
/// segments' length, where the first segment's own curvature is of first.
Vec3 root_darboux(const HangingRod& rod, const Eigen::VectorXd& q);

/// The angle between the tangents at tip and root, in [0, pi].
double tip_angle(const HangingRod& rod, const Eigen::VectorXd& q);

}  // namespace lancret
