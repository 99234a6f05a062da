#pragma once
// Second derivatives of a segment with respect to its curvatures: what the velocity terms
// and the geometric stiffness are made of. All in the frame at the segment's start.

#include "guides/base/types.h"
#include "sim/segment/stumpff.h"

namespace lancret {

/// A segment at arc length u from its start, ready for derivatives in any direction.
class SegmentSecondDerivative {
  public:
    /// `k` is the Darboux vector, 1/cm, `u` the arc length, cm.
    SegmentSecondDerivative(const Vec3& k, double u);

    /// D^2 p [a, b], symmetric in a and b: of the position, cm for a and b in 1/cm.
    Vec3 position(const Vec3& a, const Vec3& b) const;
    /// (D V [a]) b: how the rotation vector V b changes as k moves by a. Not symmetric:
    /// rotations do not commute.
    Vec3 angular(const Vec3& a, const Vec3& b) const;

  private:
    Vec3 k_;
    double u_;
    double p2_, p3_;    ///< u^2 c2, u^3 c3
    double d2_, d3_;    ///< 2 u^4 c2', 2 u^5 c3'
    double dd2_, dd3_;  ///< 4 u^6 c2'', 4 u^7 c3''
};

}  // namespace lancret
