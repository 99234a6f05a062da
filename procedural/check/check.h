#pragma once
// The check: measures every strand independently of the code that made it, from the
// places and frames of synthesis and the control points of expansion.

#include <cstdint>
#include <vector>

#include "guides/helix/guides.h"
#include "procedural/check/tolerances.h"
#include "procedural/expand/expand.h"

namespace lancret {

/// The measurements of one strand.
struct StrandCheck {
    std::uint32_t strand = 0;        ///< its id
    bool finite = true;              ///< every place, frame and control point
    bool tip_within_reach = true;    ///< the tip is no farther from the root than the
                                     ///< strand is long
    bool inside_hull = true;         ///< kappa and tau lie between those of the guides;
                                     ///< intervals that contain a joint are not measured
    float orthogonality = 0;         ///< max |R^T R - I| over its frames
    float length_error = 0;          ///< arc length / intended length - 1
    float emitted_length_error = 0;  ///< the same for the emitted curve
    float distance = 0;              ///< cm, max from the emitted curve to the strand
    float root_distance = 0;  ///< cm, from the start of the emitted curve to the root
};

struct CheckReport {
    CheckTolerances tolerances;
    bool hull_applies = true;          ///< whether the blend interpolates kappa and tau
    std::vector<StrandCheck> strands;  ///< [children], in their order

    /// The largest fraction of a tolerance that `strand` uses. It fails above 1. Infinite
    /// if a flag fails or a measurement is NaN.
    double severity(const StrandCheck& strand) const;
    bool passes(const StrandCheck& strand) const;
    /// Whether every strand passes.
    bool pass() const;
    /// The n strands of largest severity, worst first.
    std::vector<StrandCheck> worst(std::size_t n) const;
};

/// The children of one time, with the curves that expansion made of them.
struct CheckInput {
    const Binding& binding;        ///< posed at that time
    const Guides& guides;          ///< of `classed`
    const ClassedGuides& classed;  ///< as used by expansion
    const Curves& curves;
    const ExpandSettings& settings;
    double length_scale = 1;  ///< children's length over their guides'
    CheckTolerances tolerances{};
};

/// Measures every child, each at its class. Arc length is measured from the chords
/// between places and the rotations between frames, and by quadrature for the emitted
/// curve. Curvature and torsion are compared with those of the guides.
CheckReport check_strands(const CheckInput& input);

}  // namespace lancret
