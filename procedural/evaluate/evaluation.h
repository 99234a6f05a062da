#pragma once
// How near each blend comes to the strands that were left out.

#include "procedural/evaluate/leave_out.h"

namespace lancret {

/// What came of one blend.
struct BlendEvaluation {
    Blend blend = Blend::option1;
    StrandFigures figures;
    /// |length of the strand as synthesised / intended length - 1|: the intended length
    /// is the weighted length of its guides.
    double length_error_mean = 0, length_error_max = 0;
    double ns_per_point = 0;  ///< on one thread; a point is a place on a child
};

/// The number of intervals that children are synthesised at: a multiple of the guides'
/// segments, kCompareSteps at least, such that 99 in 100 intervals of the guides turn by
/// half a radian at most; 512 at most where the segments allow it.
int evaluation_intervals(const Guides& guides);

/// The children of `taken` as a blend makes them, at kCompareSteps.
struct Prediction {
    StrandSamples strands;
    std::vector<Vec3f> tangents;        ///< there, unit
    std::vector<double> length_errors;  ///< [children], relative, signed
};

/// Synthesises every left-out strand as rendering does. Throws std::runtime_error where a
/// place is not finite. The same for any number of threads.
Prediction predict(const HoldOut& taken, const GuideProfiles<float>& profiles,
                   Blend blend);

/// predict, its figures, and what a point costs: the least of several runs over a part of
/// the children on the calling thread. All but the cost is the same for any number of
/// threads.
BlendEvaluation evaluate_blend(const HoldOut& taken, const GuideProfiles<float>& profiles,
                               Blend blend);

}  // namespace lancret
