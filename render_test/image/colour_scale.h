#pragma once
// From numbers to colours that show them evenly: paths through the OKLab space
// [Ottosson 2020, "A perceptual color space for image processing"]. All colours are
// linear and within the gamut of sRGB.

#include <cstdint>
#include <optional>
#include <string>

#include "guides/base/types.h"

namespace lancret {

/// The colour of an OKLab lightness (0..1), chroma and hue (degrees), clamped to the
/// gamut.
Vec3f oklab_colour(float lightness, float chroma, float hue);

/// For `t` in 0..1, clamped: from violet through blue and green to yellow, with lightness
/// linear in `t`.
Vec3f sequential_colour(float t);

/// For `t` in -1..1, clamped: from blue through light grey at zero to orange,
/// symmetrically darker away from zero.
Vec3f diverging_colour(float t);

/// The colour of a category: hues a golden section of the circle apart, in three
/// lightnesses.
Vec3f category_colour(std::uint32_t category);

/// Values that break a tolerance; on none of the paths above.
inline const Vec3f kFailColour(0.8f, 0.02f, 0.015f);
/// Values within tolerance that need no attention.
inline const Vec3f kCleanColour = Vec3f::Constant(0.2f);

/// How a figure becomes a colour.
struct ColourScale {
    enum class Kind {
        sequential,  ///< linear from low to high
        diverging,   ///< linear, with neutral grey in the middle
        logarithmic  ///< low > 0
    };
    Kind kind = Kind::sequential;
    float low = 0, high = 1;  ///< low < high; values beyond get the colour of that end
    std::string over;  ///< label of values above `high`, which are then red; empty:
                       ///< they get the colour of the end
    std::optional<float> clean;  ///< values up to this are grey
};

/// Position of `value` on the scale, 0..1.
float scale_place(const ColourScale& scale, float value);
/// The colour at a position on the scale, 0..1.
Vec3f scale_colour_at(const ColourScale& scale, float place);
/// The colour of a value: that of its position, kFailColour or kCleanColour.
Vec3f scale_colour(const ColourScale& scale, float value);

}  // namespace lancret
