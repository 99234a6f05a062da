#pragma once
// The distance of an emitted curve from a helix, in closed form.

#include <cmath>

#include "procedural/curves/curves.h"

namespace lancret::test {

/// The largest distance, at equal arc length, between the helix of Darboux vector `u` and
/// its emitted curve at steps `ds`, cm. A helix is the sum of a line, which both bases
/// reproduce, and a circle of radius kappa / |u|^2. Both bases deviate from the circle
/// most in the middle of an interval, to the inside: with w = |u| ds, Hermite is at
/// cos(w/2) + (w/4) sin(w/2) of the radius, and the quasi-interpolant at
/// L (23 cos(w/2) + cos(3w/2)) / 24 with L = 1 + x/6 + x^2/36, x = 2 - 2 cos(w). The
/// leading term of both is 1 - w^4 / 384.
inline double cubic_error(const Vec3& u, double ds, CurveBasis basis) {
    const double w = u.norm() * ds, x = 2 - 2 * std::cos(w);
    if (w < 1e-3) return 0;  // below the precision of 1 - w^4 / 384
    const double share =
        basis == CurveBasis::hermite
            ? std::cos(w / 2) + w / 4 * std::sin(w / 2)
            : (1 + x / 6 + x * x / 36) * (23 * std::cos(w / 2) + std::cos(1.5 * w)) / 24;
    return std::hypot(u.y(), u.z()) / u.squaredNorm() * std::abs(share - 1);
}

}  // namespace lancret::test
