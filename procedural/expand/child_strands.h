#pragma once

#include "guides/strand/strands.h"
#include "procedural/expand/expand.h"

namespace lancret {

/// The children as points on the strands (not control points) and diameters, for export.
/// Ordered by id; a strand has one point more than its class has intervals.
Strands child_strands(const Binding& binding, const ClassedGuides& guides,
                      const ExpandSettings& settings);

}  // namespace lancret
