#pragma once
// From a curve to its Frenet-Serret apparatus [TW99, Sec. 4.2]: at points, and as a
// profile that synthesizes the curve again.
//
// N is continuous: through an inflection it keeps its direction and kappa changes sign,
// and on straight stretches it is carried from the nearest place that bends, by the
// rotation-minimising frame.

#include <span>
#include <vector>

#include "guides/frenet/frenet_serret.h"
#include "guides/strand/curve.h"

namespace lancret {

/// A place of a strand counts as straight if |kappa| times the strand's length is below
/// this, radian.
constexpr double kStraightTurn = 1e-6;

/// The apparatus at a place of a curve.
struct FrenetPoint {
    HelixState<double> state;  ///< frame [T N B] and position
    FrenetRates rates;         ///< kappa is signed; both are 0 where straight
};

/// The apparatus at samples of a curve, given its derivatives in any parameter [TW99,
/// Eq. 39-41]. N keeps its side: it is negated if it would turn by more than pi/2 about
/// the tangent from the previous sample (the paper's rule B(s+ds) . B(s) < 0), so samples
/// must be so close that its true turn is less. kappa is positive where the strand first
/// bends. A strand that is straight throughout has N = across_tangent(hint, T) at its
/// root. Where the speed is zero the tangent is that of the previous sample, or of the
/// first that has one.
std::vector<FrenetPoint> frenet_points(std::span<const CurvePoint> samples,
                                       const Vec3& hint,
                                       double straight_turn = kStraightTurn);

/// The profile whose rates are the means of the point values at the ends of each
/// interval; `steps` ([points - 1], cm) are the arc lengths between them. Order 2. Unlike
/// profile_of_frames it needs an accurate third derivative.
FrenetProfile profile_of_points(std::span<const FrenetPoint> points,
                                std::span<const double> steps);

enum class FrenetMethod {
    frames,        ///< from successive frames [TW99, Eq. 43-48, corrected]
    point_values,  ///< means of the values at points [TW99, Eq. 39-41]
};

/// The profile of `curve` over n >= 1 intervals of equal arc length; throws
/// std::invalid_argument otherwise. The synthesized strand deviates from the curve by
/// order 2 in the interval, and has the curve's length. N is tracked at four or more
/// places per piece of the curve, so that a coarse profile loses neither turns nor signs.
/// `hint` is the normal of a straight strand: the scalp's tangent.
FrenetProfile analyze(const Curve& curve, int n, const Vec3& hint,
                      FrenetMethod method = FrenetMethod::frames,
                      double straight_turn = kStraightTurn);

}  // namespace lancret
