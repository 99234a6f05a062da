#pragma once
// The effect of a whole segment on everything beyond it.

#include "guides/helix/helix.h"
#include "sim/segment/kernel.h"

namespace lancret {

/// The end of a segment, in the frame at its start.
struct SegmentEnd {
    Mat3 rotation;  ///< E
    Vec3 position;  ///< p(l), cm
    Mat3 angular;   ///< V: dk turns the end by the rotation vector V dk, cm
    Mat3 jacobian;  ///< J = dp/dk, cm^2
};

inline SegmentEnd segment_end(const Vec3& k, double length) {
    const double x = length * length * k.squaredNorm();
    const int halvings = stumpff_halvings(x);
    const Stumpff<double> c = stumpff_functions(x, halvings);
    const auto [p, j] = segment_point<double>(k.data(), length, halvings);
    const double a1 = length * c.c1, a2 = length * length * c.c2,
                 a3 = length * length * length * c.c3;
    const Mat3 turn = hat<double>(k), outer = k * k.transpose();
    SegmentEnd out;
    out.rotation = a1 * turn + a2 * outer;
    out.rotation.diagonal().array() += 1 - c.c2 * x;
    out.angular = a2 * turn + a3 * outer;
    out.angular.diagonal().array() += length - a3 * k.squaredNorm();
    out.position = Vec3::Map(p);
    out.jacobian =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&j[0][0]);
    return out;
}

}  // namespace lancret
