#pragma once
// The children of a groom before they are grown: their roots, their binding and their
// interval counts.

#include "procedural/groom/placed_guides.h"
#include "procedural/roots/child_roots.h"

namespace lancret {

/// The root places of all children, at full density. Throws InputError.
RootPlaces child_places(const GroomSettings& groom, const PlacedGuides& placed);

/// The roots of the children `ids`, which ascend.
Roots child_roots(const PlacedGuides& placed, const RootPlaces& places,
                  std::span<const std::uint32_t> ids);

/// The roots of those of `ids` that are grown at a density, with their widths.
Roots pruned_roots(const GroomSettings& groom, const PlacedGuides& placed,
                   const RootPlaces& places, std::span<const std::uint32_t> ids,
                   double density);

/// Binds any subset of a groom's children. A child's binding does not depend on the
/// others in the subset.
Binding bind_children(const GroomSettings& groom, const PlacedGuides& placed,
                      Roots roots);

/// A sample of the children at full density, bound. Interval counts are chosen from it so
/// that they do not depend on chunks or density.
Binding sample_of_children(const GroomSettings& groom, const PlacedGuides& placed,
                           const RootPlaces& places);

/// The number of intervals per strand: the groom's setting, or what its tolerance needs.
/// Throws InputError.
int child_intervals(const GroomSettings& groom, const PlacedGuides& placed,
                    const Binding& sample);

/// The interval counts of the children of each guide, at most `finest`. A single class if
/// the groom does not adapt.
StrandClasses child_classes(const GroomSettings& groom, const PlacedGuides& placed,
                            const Binding& sample, int finest);

}  // namespace lancret
