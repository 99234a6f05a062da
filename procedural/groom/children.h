#pragma once
// The children of a groom before they are grown: where they stand, what they are bound
// to, how finely they are cut.

#include "procedural/groom/placed_guides.h"
#include "procedural/roots/child_roots.h"

namespace lancret {

/// Where all of a groom's children stand, whatever its density. Throws InputError.
RootPlaces child_places(const GroomSettings& groom, const PlacedGuides& placed);

/// The roots of some children; `ids` ascend.
Roots child_roots(const PlacedGuides& placed, const RootPlaces& places,
                  std::span<const std::uint32_t> ids);

/// Those of `ids` that are grown at a density, with their widths.
Roots pruned_roots(const GroomSettings& groom, const PlacedGuides& placed,
                   const RootPlaces& places, std::span<const std::uint32_t> ids,
                   double density);

/// Binds any of a groom's children: which others are bound at the same time changes
/// nothing.
Binding bind_children(const GroomSettings& groom, const PlacedGuides& placed,
                      Roots roots);

/// The first children, all of them whatever the density: what says how many intervals
/// strands are cut into, so that no chunk and no density changes that.
Binding sample_of_children(const GroomSettings& groom, const PlacedGuides& placed,
                           const RootPlaces& places);

/// The number of intervals a strand, as the groom says or its tolerance asks. Throws
/// InputError.
int child_intervals(const GroomSettings& groom, const PlacedGuides& placed,
                    const Binding& sample);

/// How finely the children of each guide are cut, of at most `finest` intervals: all
/// alike where the groom does not adapt.
StrandClasses child_classes(const GroomSettings& groom, const PlacedGuides& placed,
                            const Binding& sample, int finest);

}  // namespace lancret
