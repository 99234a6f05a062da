#pragma once
// A texture and its interpolation.

#include <cstddef>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

/// Linear RGB texels, row by row from the top.
struct Texture {
    int width = 0, height = 0;
    std::vector<Vec3f> texels;  ///< [width * height]

    const Vec3f& at(int x, int y) const { return texels[std::size_t(y) * width + x]; }
};

/// Bilinear between texel centres; UVs outside [0, 1] repeat, and v runs upward.
Vec3f texture_colour(const Texture& map, const Vec2f& uv);

}  // namespace lancret
