#pragma once
// Second derivatives of a segment with respect to its curvatures, for the velocity terms
// and the geometric stiffness. Everything is expressed in the frame at the segment's
// start.

#include "guides/base/types.h"
#include "sim/segment/stumpff.h"

namespace lancret {

/// Directional derivatives of a segment at arc length u from its start.
class SegmentSecondDerivative {
  public:
    /// `k` is the Darboux vector, 1/cm, `u` the arc length, cm.
    SegmentSecondDerivative(const Vec3& k, double u);

    /// D^2 p [a, b], the second derivative of the position, symmetric in a and b; cm for
    /// a and b in 1/cm.
    Vec3 position(const Vec3& a, const Vec3& b) const;
    /// (D V [a]) b, the change of the rotation vector V b as k changes by a. Not
    /// symmetric: rotations do not commute.
    Vec3 angular(const Vec3& a, const Vec3& b) const;

  private:
    Vec3 k_;
    double p2_, p3_;    ///< u^2 c2, u^3 c3
    double d2_, d3_;    ///< 2 u^4 c2', 2 u^5 c3'
    double dd2_, dd3_;  ///< 4 u^6 c2'', 4 u^7 c3''
};

}  // namespace lancret
