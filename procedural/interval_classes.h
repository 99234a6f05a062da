#pragma once
// Strands cut as finely as each of them needs: a few classes of interval counts, so that
// every class has strands of one size and can be a geometry of its own.

#include <cstdint>
#include <vector>

#include "guides/strands.h"
#include "procedural/expand.h"

namespace lancret {

struct IntervalClasses {
    std::vector<int> counts;  ///< intervals a strand, finest first: multiples of the
                              ///< guides' segments, then halves of these, down to 1
    std::vector<GuideProfiles<float>> profiles;  ///< [classes]

    std::size_t size() const { return counts.size(); }
};

IntervalClasses interval_classes(const Guides& guides, int finest);

/// How far the emitted curve of a child at a class lies from the child at the finest, cm:
/// the farthest, as seen at the places of the finest and halfway between them, across the
/// strand. Infinite where something is not finite.
double adapted_distance(const Binding& binding, const IntervalClasses& classes,
                        std::size_t child, std::size_t at_class,
                        const ExpandSettings& settings);

/// [children] The class of each: a coarse one at which the child is within 0.9
/// `tolerance` cm of its shape at the finest (between the places looked at it may go
/// further), found by halving; the finest where that is not to be had. A function of the
/// child's binding and guides alone.
std::vector<std::uint8_t> child_classes(const Binding& binding,
                                        const IntervalClasses& classes, double tolerance,
                                        const ExpandSettings& settings);

/// The children of each class, [classes]; Curves::ids says which they are.
std::vector<Curves> expand_by_class(const Binding& binding,
                                    const IntervalClasses& classes,
                                    std::span<const std::uint8_t> of_child,
                                    const ExpandSettings& settings);

/// The children in their order, as points on the strands, each with as many as its class
/// has.
Strands adapted_strands(const Binding& binding, const IntervalClasses& classes,
                        std::span<const std::uint8_t> of_child,
                        const ExpandSettings& settings);

}  // namespace lancret
