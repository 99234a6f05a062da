#pragma once

#include <cstdint>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

/// For each vertex the first vertex at exactly the same position (-0 equals 0), which may
/// be the vertex itself. Joins what a UV seam separates.
std::vector<std::uint32_t> welded(const std::vector<Vec3f>& positions);

}  // namespace lancret
