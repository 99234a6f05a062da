#pragma once

#include "guides/strand/strands.h"
#include "procedural/expand/expand.h"

namespace lancret {

/// The children as points on the strands themselves (not control points), with their
/// diameters: what other programs read. They stand in the order of their ids, each with
/// one point more than its class has intervals.
Strands child_strands(const Binding& binding, const ClassedGuides& guides,
                      const ExpandSettings& settings);

}  // namespace lancret
