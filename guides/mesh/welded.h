#pragma once

#include <cstdint>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

/// For each vertex the first vertex at the very same position (-0 is 0): itself where
/// there is no earlier one. So what a UV seam parted is one again.
std::vector<std::uint32_t> welded(const std::vector<Vec3f>& positions);

}  // namespace lancret
