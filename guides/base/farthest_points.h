#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

/// Indices of `count` of the points (cm), each the farthest from those before it: any
/// number of them covers the set evenly, and a smaller choice is the beginning of a
/// larger one. `seed` draws the first; of equal distances the lower index is taken. All
/// points, in order, if count >= points.size(). Points that coincide with a chosen one
/// come last. Takes about n log n time.
std::vector<std::uint32_t> farthest_points(std::span<const Vec3> points,
                                           std::size_t count, std::uint64_t seed);

/// The distance of each point to its nearest neighbour, cm; infinity for a single point.
std::vector<double> neighbour_distances(std::span<const Vec3> points);

}  // namespace lancret
