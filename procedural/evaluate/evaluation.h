#pragma once
// How well each blend predicts the held-out strands.

#include <string>

#include "procedural/evaluate/hold_out.h"

namespace lancret {

/// The result for one blend.
struct BlendEvaluation {
    Blend blend = Blend::option1;
    StrandFigures figures;
    /// |synthesised length / intended length - 1|, mean and maximum over the strands. The
    /// intended length is the weighted mean of the guides' lengths.
    double length_error_mean = 0, length_error_max = 0;
    double ns_per_point = 0;  ///< synthesis on one thread, per place on a child
    std::string code;         ///< the code that was timed: see synthesis_code
};

/// The number of intervals that children are synthesised with: a multiple of the guides'
/// segments, at least kCompareSteps, with which 99 % of the guides' intervals turn by at
/// most half a radian; at most 512 if the segments allow it.
int evaluation_intervals(const Guides& guides);

/// The held-out strands as a blend predicts them, sampled at kCompareSteps.
struct Prediction {
    StrandSamples strands;
    std::vector<Vec3f> tangents;        ///< unit, at each point of `strands`
    std::vector<double> length_errors;  ///< [children], relative, signed
};

/// Synthesises every held-out strand with the code that rendering uses. The result is the
/// same for any number of threads; between instruction sets it differs by round-off.
/// Throws std::runtime_error if a place is not finite.
Prediction predict(const HoldOut& holdout, const GuideProfiles<float>& profiles,
                   Blend blend);

/// predict, its figures and its cost. The cost is the fastest of several runs over a part
/// of the children on the calling thread; all else is the same for any number of threads.
BlendEvaluation evaluate_blend(const HoldOut& holdout,
                               const GuideProfiles<float>& profiles, Blend blend);

}  // namespace lancret
