#pragma once
// Strands whose torsion is a constant times their curvature, h = tau / kappa: the one
// case with closed frames for any curvature [TW99, Sec. 3.2]. They are the generalised
// helices of Lancret's theorem.

#include <functional>
#include <vector>

#include "guides/frenet/frenet_serret.h"

namespace lancret {

/// A strand of constant helicity, cut off at `length`.
struct ConstantHelicity {
    HelixState<double> root;  ///< [T N B] and position, cm
    double helicity = 0;      ///< h = tau / kappa; any sign, 0 is planar
    /// q(s), the integral of kappa from the root, radian [TW99, Eq. 17]. q(0) = 0. kappa
    /// may have either sign.
    std::function<double(double)> turn;
    double length = 0;  ///< cm
};

/// R(0)^T R(q): the frame after the turn q, expressed in the root frame [TW99, Eq.
/// 18-24]. In q the equations have constant coefficients, so this is the one helix step
/// of Darboux vector (h, 0, 1) and length q.
Mat3 constant_helicity_rotation(double helicity, double q);

/// The unit axis to which the tangent has a constant angle, cosine h / sqrt(1 + h^2):
/// N(0) x Gamma = (h T + B) / sqrt(1 + h^2) [TW99, Eq. 25: Lancret's theorem].
Vec3 lancret_axis(const Mat3& frame, double helicity);

/// The strand at s = i length / n, i = 0 .. n, root first (n >= 1, else
/// std::invalid_argument). Frames are closed; positions are their tangent integrated by
/// 5-point Gauss quadrature over parts that turn by at most 1/2, at least four per
/// interval: to round-off if kappa changes little over a part.
std::vector<HelixState<double>> constant_helicity_strand(const ConstantHelicity& strand,
                                                         int n);

/// The profile of its n equal intervals with the mean rates, kappa = (q(s + ds) - q(s)) /
/// ds and tau = h kappa. Synthesis gives the frames to round-off, because Q(s) commutes
/// with itself, and positions to order 2.
FrenetProfile constant_helicity_profile(const ConstantHelicity& strand, int n);

}  // namespace lancret
