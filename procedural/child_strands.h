#pragma once

#include "guides/strands.h"
#include "procedural/expand.h"

namespace lancret {

/// The children as points on the strands themselves (not control points), with their
/// diameters: what other programs read. profiles.count + 1 points a strand.
Strands child_strands(const Binding& binding, const GuideProfiles<float>& profiles,
                      const ExpandSettings& settings);

}  // namespace lancret
