#pragma once
// The cyclone: a strand whose radius of curvature is linear in arc length, at constant
// helicity [TW99, Fig. 1]. All of its quantities have closed forms.

#include <vector>

#include "guides/frenet/constant_helicity.h"

namespace lancret {

struct Cyclone {
    double radius = 1;    ///< of curvature at the root, cm, > 0
    double growth = 0.1;  ///< of that radius per arc length; 0 is a helix
    double helicity = 0;  ///< tau / kappa; positive is right-handed
    double length = 1;    ///< cm, > 0; radius + growth * length must be > 0
};

/// q(s), the integral of kappa = 1 / (radius + growth s), radian: a logarithm. 0 <= s <=
/// length.
double cyclone_turn(const Cyclone& cyclone, double s);

/// The place at arc length s of the cyclone on `root` (frame [T N B]). Throws
/// std::invalid_argument if the radius is not positive up to the tip.
HelixState<double> cyclone_state(const Cyclone& cyclone, const HelixState<double>& root,
                                 double s);

/// The states at s = i length / n, i = 0 .. n, root first; n >= 1. Throws as
/// cyclone_state.
std::vector<HelixState<double>> cyclone_strand(const Cyclone& cyclone,
                                               const HelixState<double>& root, int n);

/// The cyclone on `root` as a strand of constant helicity. Throws as cyclone_state.
ConstantHelicity constant_helicity(const Cyclone& cyclone,
                                   const HelixState<double>& root);

}  // namespace lancret
