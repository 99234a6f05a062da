#pragma once
// From a curve to its Frenet-Serret apparatus [TW99, Sec. 4.2]: at points, and as a
// profile that synthesizes the curve again.
//
// N is carried along: through an inflection it keeps its direction and kappa changes
// sign, and where the strand is straight it comes from the nearest place where it is not,
// by the rotation-minimising frame.

#include <span>
#include <vector>

#include "guides/frenet/frenet_serret.h"
#include "guides/strand/curve.h"

namespace lancret {

/// The turn over a strand's whole length, radian, below which it counts as straight: a
/// place is straight where |kappa| times the length is below.
constexpr double kStraightTurn = 1e-6;

/// The apparatus at a place of a curve.
struct FrenetPoint {
    HelixState<double> state;  ///< frame [T N B] and position
    FrenetRates rates;         ///< kappa signed; both 0 where the strand is straight
};

/// The apparatus at samples of a curve, given its derivatives in any parameter [TW99,
/// Eq. 39-41]. N keeps its side: it is negated where it would turn by over pi/2 about the
/// tangent since the sample before (the paper's rule B(s+ds) . B(s) < 0), so samples must
/// be near enough that it turns less by itself. kappa is positive where the strand first
/// bends. A strand straight all along has N = across_tangent(hint, T), carried on. Where
/// the speed vanishes the tangent is that of the sample before, or of the first with one.
std::vector<FrenetPoint> frenet_points(std::span<const CurvePoint> samples,
                                       const Vec3& hint,
                                       double straight_turn = kStraightTurn);

/// The profile whose rates are the means of the point values at the ends of each
/// interval; `steps` ([points - 1], cm) are the arc lengths between them. Order 2; it
/// needs a third derivative that can be trusted, unlike profile_of_frames.
FrenetProfile profile_of_points(std::span<const FrenetPoint> points,
                                std::span<const double> steps);

enum class FrenetMethod {
    frames,        ///< from successive frames [TW99, Eq. 43-48, corrected]
    point_values,  ///< means of the values at points [TW99, Eq. 39-41]
};

/// The profile of `curve` over n intervals of equal arc length (n >= 1, else
/// std::invalid_argument). The synthesized strand is off the curve by order 2 in the
/// interval, and its length is the curve's. N is tracked at four places a piece of the
/// curve at least, so that a coarse profile neither loses turns nor signs. `hint` is the
/// normal of a straight strand: the scalp's tangent.
FrenetProfile analyze(const Curve& curve, int n, const Vec3& hint,
                      FrenetMethod method = FrenetMethod::frames,
                      double straight_turn = kStraightTurn);

}  // namespace lancret
