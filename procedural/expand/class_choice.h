#pragma once
// Which class of interval counts the children of each guide need: measured on a sample of
// them by the scalar blends, so that it is the same in every chunk, at every density and
// on every machine.

#include "procedural/expand/expand.h"

namespace lancret {

/// Every count that strands may have, at most kMaxClasses: `finest`, multiples of the
/// guides' segments, on which profiles are exact, then halves of these down to 1. Every
/// guide has the coarsest, to be refined.
StrandClasses coarsest_classes(const Guides& guides, int finest);

/// Makes the classes of guides finer where they must be for the children of `sample` that
/// each leads, at the time of `guides`: that at their class emitted curves stay, across
/// the strand, within 0.6 `tolerance` cm of the child at the finest, that their length
/// changes by at most 0.005 of itself, and that no interval turns by more than 2 radians.
/// The finest is always taken to do. So that children beyond the sample keep the
/// tolerance too, the others in which a guide has a weight of 0.25 count as led by it. A
/// guide without any is measured on a child that is its image.
void refine_classes(StrandClasses& classes, const Binding& sample, const Guides& guides,
                    double tolerance, const ExpandSettings& settings);

/// Without the classes that no guide has.
StrandClasses used_classes(const StrandClasses& classes);

/// How far the emitted curve of a child at the intervals of `coarse` lies from the child
/// at those of `fine`, cm: the farthest, as seen at the places of the finest and halfway
/// between them, across the strand. Infinite where something is not finite.
double adapted_distance(const Binding& binding, const GuideProfiles<float>& fine,
                        const GuideProfiles<float>& coarse, std::size_t child,
                        const ExpandSettings& settings);

/// What is seen of the classes of all children.
struct AdaptedReport {
    double farthest = 0;     ///< cm, the largest adapted_distance; 0 at the finest
    std::size_t beyond = 0;  ///< children that go beyond the tolerance
};

/// Looks at all children of `binding`, at the time of `guides`; `fine` are the profiles
/// of that time on the finest count that a strand could have.
AdaptedReport adapted_report(const Binding& binding, const ClassedGuides& guides,
                             const GuideProfiles<float>& fine, double tolerance,
                             const ExpandSettings& settings);

}  // namespace lancret
