#pragma once
// Chooses the interval counts for the children of each guide. They are measured on a
// sample of the children with the scalar blends, so they are the same in every chunk, at
// every density and on every machine.

#include "procedural/expand/expand.h"

namespace lancret {

/// All counts that strands may have, at most kMaxClasses: `finest`, then multiples of the
/// guides' segments, on which profiles are exact, then halves down to 1. Every guide
/// starts with the coarsest class.
StrandClasses coarsest_classes(const Guides& guides, int finest);

/// Makes the classes of guides finer as needed at the time of `guides`, for the children
/// of `sample` that each guide leads: at its class the emitted curve of a child stays
/// within kSampleShare `tolerance` cm of the child at the finest class (measured across
/// the strand), its length changes by at most 0.005 of itself, and no interval turns by
/// more than kMaxTurn. The finest class is assumed to be sufficient. A guide with a
/// weight of at least 0.25 in a child counts as leading it too, so that children outside
/// the sample also keep the tolerance. A guide that leads no child of the sample is
/// measured on a child that is its copy.
void refine_classes(StrandClasses& classes, const Binding& sample, const Guides& guides,
                    double tolerance, const ExpandSettings& settings);

/// The same classes without those that no guide has.
StrandClasses used_classes(const StrandClasses& classes);

/// The largest distance between the emitted curve of a child at the intervals of `coarse`
/// and the child at those of `fine`, cm: measured across the strand, at the places of the
/// finest and halfway between them. Infinite if anything is not finite.
double adapted_distance(const Binding& binding, const GuideProfiles<float>& fine,
                        const GuideProfiles<float>& coarse, std::size_t child,
                        const ExpandSettings& settings);

/// What adapting the number of points costs in accuracy.
struct AdaptedReport {
    double farthest = 0;     ///< cm, the largest adapted_distance; 0 at the finest class
    std::size_t beyond = 0;  ///< number of children beyond the tolerance
};

/// Measures all children of `binding` at the time of `guides`. `fine` are the profiles of
/// that time at the finest count that a strand could have.
AdaptedReport adapted_report(const Binding& binding, const ClassedGuides& guides,
                             const GuideProfiles<float>& fine, double tolerance,
                             const ExpandSettings& settings);

}  // namespace lancret
