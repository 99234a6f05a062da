#pragma once
// Measurements of a hanging rod: lowest point, curvature at the root, angle of the tip.

#include "sim/rod/energy.h"

namespace lancret {

struct LowestPoint {
    double height = 0;  ///< along `up`, cm
    double s = 0;       ///< arc length, cm
};

/// The lowest point along the unit vector `up`, anywhere on the curve.
LowestPoint lowest_point(const HangingRod& rod, const Eigen::VectorXd& q, const Vec3& up);

/// The Darboux vector at s = 0, 1/cm, from the balance of moments: the natural one + K^-1
/// times the weight's moment about the root, in the root's frame. Its error is of second
/// order in the segments' length, that of the first segment's curvature of first order.
Vec3 root_darboux(const HangingRod& rod, const Eigen::VectorXd& q);

/// The angle between the tangents at tip and root, in [0, pi].
double tip_angle(const HangingRod& rod, const Eigen::VectorXd& q);

}  // namespace lancret
