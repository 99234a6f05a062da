#pragma once
// A point of a segment and its derivative with respect to the segment's curvatures,
// without a singularity: the inner loop of the dynamics. Everything is expressed in the
// frame at the segment's start.

#include "sim/segment/stumpff.h"

namespace lancret {

/// Position p(u) from the segment's start (cm) and J = dp/dk, j[row][column of k], cm^2.
template <class T>
struct SegmentPoint {
    T p[3];
    T j[3][3];
};

/// The point at arc length u (cm) from the start of a segment with Darboux vector k
/// (1/cm): p = u e0 + u^2 c2 K e0 + u^3 c3 K^2 e0, K = hat(k), and its derivative. T is
/// as for stumpff_functions; `halvings` must be enough for u |k|.
template <class T>
SegmentPoint<T> segment_point(const double* k, const T& u, int halvings) {
    const T k0(k[0]), k1(k[1]), k2(k[2]);
    const double bending = k[1] * k[1] + k[2] * k[2];
    const T square(k[0] * k[0] + bending);
    const T u2 = u * u, u3 = u2 * u;
    const Stumpff<T> c = stumpff_functions<T>(u2 * square, halvings);
    const T a2 = u2 * c.c2, a3 = u3 * c.c3;
    // K^2 e0 = k0 k - |k|^2 e0.
    const T s0(-bending), s1(k[0] * k[1]), s2(k[0] * k[2]);
    // Derivative with respect to |k|: 2 u^4 c2' K e0 + 2 u^5 c3' K^2 e0, times k_i.
    const T g2 = u2 * u2 * (T(2.0) * c.c4 - c.c3);
    const T g3 = u2 * u3 * (T(3.0) * c.c5 - c.c4);
    const T g[3] = {g3 * s0, g2 * k2 + g3 * s1, g3 * s2 - g2 * k1};
    const T twice = a3 + a3, along = a3 * k0;
    return {{u + a3 * s0, a2 * k2 + a3 * s1, a3 * s2 - a2 * k1},
            {{g[0] * k0, (g[0] - twice) * k1, (g[0] - twice) * k2},
             {a3 * k1 + g[1] * k0, along + g[1] * k1, a2 + g[1] * k2},
             {a3 * k2 + g[2] * k0, g[2] * k1 - a2, along + g[2] * k2}}};
}

}  // namespace lancret
