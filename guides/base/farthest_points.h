#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

/// `count` of the points (cm), each the farthest from those before it, so that any number
/// of them covers the set evenly and a smaller choice is the beginning of a larger one.
/// The first is drawn by `seed`; ties go to the lower index. All of them where count >=
/// points.size(). Points that coincide with a chosen one come last. About n log n in
/// time.
std::vector<std::uint32_t> farthest_points(std::span<const Vec3> points,
                                           std::size_t count, std::uint64_t seed);

/// The distance of each point to its nearest neighbour, cm; infinity for a single point.
std::vector<double> neighbour_distances(std::span<const Vec3> points);

}  // namespace lancret
