#pragma once
// The cost of pictures.

#include <cstddef>
#include <cstdint>

namespace lancret {

/// The cost of one picture, or of several together. Times in seconds.
struct PictureCost {
    double bind = 0, expand = 0, bvh = 0, render = 0;
    double first = 0;  ///< the part of `render` until the first picture was written
    std::uint64_t rays = 0, paths = 0;
    std::size_t bvh_bytes = 0;
};

/// Adds the cost of a picture to the total, whose `first` is that of the first picture
/// and whose `bvh_bytes` is the maximum.
void add_cost(const PictureCost& cost, bool is_first, PictureCost& total);

}  // namespace lancret
