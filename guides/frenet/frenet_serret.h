#pragma once
// The Frenet-Serret apparatus of a strand, interval by interval: synthesis [TW99,
// Sec. 4.1] and analysis of successive frames [TW99, Sec. 4.2]. For curves see
// guides/frenet/frenet_analysis.h.
//
// guides/frenet/ holds the paper's closed forms as a reference. Only tests include it;
// nothing that grows or simulates hair does.
//
// The paper stacks T, N, B as the rows of F; a frame here has them as columns, R = F^T.
// So its F(s + ds) = U F(s) is our R(s + ds) = R(s) E with E = U^T, and its Q is hat(u)^T
// for the Darboux vector u = (tau, 0, kappa).

#include <optional>
#include <span>
#include <vector>

#include "guides/helix/helix.h"

namespace lancret {

/// Curvature and torsion of an interval or at a place.
struct FrenetRates {
    double curvature = 0;  ///< kappa, 1/cm; negative if N continues through an inflection
    double torsion = 0;    ///< tau, 1/cm; positive for a right-handed helix

    Vec3 darboux() const { return {torsion, 0, curvature}; }
};

/// A strand as its root and the constant curvature and torsion of each interval, which
/// determine a piecewise helix with a continuous frame [TW99, Sec. 2].
struct FrenetProfile {
    HelixState<double> root;         ///< frame [T N B] and position, cm
    std::vector<double> steps;       ///< [n], cm, > 0
    std::vector<FrenetRates> rates;  ///< [n]

    std::size_t size() const { return steps.size(); }
};

/// The strand of a profile at the joints of its intervals, root first: n + 1 states
/// [TW99, Sec. 4.1, corrected: Eq. 33 and 37]. Each interval is an exact helix, so length
/// is exact at any step.
std::vector<HelixState<double>> synthesize(const FrenetProfile& profile);

/// The helix whose step of arc length `ds` (cm, > 0) is the rotation E = R(s)^T R(s + ds)
/// [TW99, Eq. 46-48, corrected: the small-angle values are b/ds and e/ds]. Turns Omega ds
/// below pi are recovered. Larger ones alias to a helix with the same end frame, Omega ds
/// - 2 pi k, and at pi both signs fit. If `expected` has the approximate rates, the
/// nearest of all these helices is returned.
FrenetRates frenet_step(const Mat3& rotation, double ds,
                        const std::optional<FrenetRates>& expected = std::nullopt);

/// The profile of n + 1 states with the arc lengths of the n intervals between them; the
/// inverse of synthesize if each turn is below pi. With `expected` ([n], or empty) larger
/// turns are recovered too. Reads no position except the first. Throws
/// std::invalid_argument if the sizes do not match.
FrenetProfile profile_of_frames(std::span<const HelixState<double>> states,
                                std::span<const double> steps,
                                std::span<const FrenetRates> expected = {});

/// The largest turn Omega ds of an interval, radian. A profile from frames is reliable
/// only if this is well below pi.
double largest_turn(const FrenetProfile& profile);

}  // namespace lancret
