#pragma once
// Drawing lines and axes.

#include <vector>

#include "guides/base/types.h"
#include "render_test/image/image.h"

namespace lancret {

inline const Vec3f kInk(0.01f, 0.015f, 0.04f), kGrey(0.45f, 0.45f, 0.45f),
    kGrid(0.85f, 0.85f, 0.85f), kAxis(0.3f, 0.3f, 0.3f), kRed(0.6f, 0.03f, 0.02f),
    kBlue(0.02f, 0.12f, 0.5f), kGreen(0.02f, 0.3f, 0.06f);
inline constexpr int kMargin = 70;   ///< around a frame, pixels
inline constexpr int kLetters = 18;  ///< height, pixels

using Line = std::vector<Vec2>;  ///< pixels, y down

/// A rectangle of the plane and its place in the picture.
struct Frame {
    Vec2 low = Vec2::Zero();    ///< lower left corner in the plane
    Vec2 scale = Vec2::Ones();  ///< pixels per unit along x and y
    int left = 0;               ///< pixels
    int top = kMargin;          ///< pixels
    Vec2 size = Vec2::Zero();   ///< pixels

    Vec2 pixel(double x, double y) const {
        return {left + (x - low.x()) * scale.x(),
                top + size.y() - (y - low.y()) * scale.y()};
    }
};

/// Draws a line with round ends and smooth edges, `width` pixels thick.
void draw_line(Image& image, const Line& line, double width, const Vec3f& colour);

/// Draws the border of the frame, a grid with labels at round numbers (the same step on
/// both axes if their scales are equal) and the name above it.
void draw_grid(Image& image, const Frame& frame, const char* name);

}  // namespace lancret
