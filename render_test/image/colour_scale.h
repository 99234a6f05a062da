#pragma once
// From numbers to colours that show them evenly: paths through the OKLab space
// [Ottosson 2020, "A perceptual color space for image processing"], whose formula is all
// there is to them. All colours are linear and within the gamut of sRGB.

#include <cstdint>

#include "guides/base/types.h"

namespace lancret {

/// Of a lightness (0..1), a chroma and a hue (degrees) in OKLab.
Vec3f oklab_colour(float lightness, float chroma, float hue);

/// 0..1, clamped: from violet over blue and green to yellow, its lightness in proportion.
Vec3f sequential_colour(float t);

/// -1..1, clamped: from blue over a light grey at zero to orange; the darker the farther
/// from zero, on either side alike.
Vec3f diverging_colour(float t);

/// Of a category: hues a golden section of the circle apart, in three lightnesses.
Vec3f category_colour(std::uint32_t category);

/// What breaks a tolerance: on none of these paths.
inline const Vec3f kFailColour(0.8f, 0.02f, 0.015f);
/// What there is nothing to say of.
inline const Vec3f kCleanColour = Vec3f::Constant(0.2f);

}  // namespace lancret
