#pragma once
// The proof: every strand looked at, by measurements of its own on the places and frames
// that synthesis exposes and on the control points that expansion made.

#include <cstdint>
#include <vector>

#include "guides/helix/guides.h"
#include "procedural/check/tolerances.h"
#include "procedural/expand/expand.h"

namespace lancret {

/// What was found on one strand.
struct StrandCheck {
    std::uint32_t strand = 0;      ///< its id
    bool finite = true;            ///< every place, frame and control point
    bool tip_within_reach = true;  ///< the tip, in the curves' box and within reach
    bool inside_hull =
        true;  ///< kappa and tau, between its guides', where no joint is near
    float orthogonality = 0;         ///< max |R^T R - I| over its places
    float length_error = 0;          ///< arc length over intended length - 1
    float emitted_length_error = 0;  ///< the same for the control points' curve
    float distance = 0;              ///< cm, the emitted curve from the strand, at most
    float root_distance = 0;         ///< cm, the emitted curve's start from the root
};

struct CheckReport {
    CheckTolerances tolerances;
    bool hull_applies = true;  ///< false for blends that do not work in kappa and tau
    std::vector<StrandCheck> strands;  ///< [children], in their order

    /// The largest share of a tolerance that `strand` uses; above 1 it fails, infinitely
    /// where something is not a matter of degree.
    double severity(const StrandCheck& strand) const;
    /// True where `strand` keeps all tolerances.
    bool passes(const StrandCheck& strand) const;
    bool pass() const;
    /// The n strands that are worst, by the largest share of a tolerance.
    std::vector<StrandCheck> worst(std::size_t n) const;
};

/// Looks at every child: at the frames and places of the very kernel that expansion used,
/// and at `curves`, which is what it made of `binding`, each at its own class. Arc length
/// is measured from the chords between places and the rotations between frames, by
/// quadrature for the emitted curve; curvature and torsion are compared with the guides'
/// own.
/// `guides` are those of `classed`.
CheckReport check(const Binding& binding, const Guides& guides,
                  const ClassedGuides& classed, const Curves& curves, Blend blend,
                  double length_scale, const CheckTolerances& tolerances);

}  // namespace lancret
