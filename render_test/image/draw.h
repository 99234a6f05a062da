#pragma once
// Text in images, and images at smaller sizes.

#include <string>

#include "render_test/image/image.h"

namespace lancret {

/// Draws `text` in an opaque linear colour. (x, y) is the start of its base line, pixels;
/// `size` is the height of letters, pixels. Returns false, without drawing, if no font is
/// found.
bool draw_text(Image& image, int x, int y, const std::string& text, int size,
               const Vec3f& colour);

/// The colours of the image at a smaller size, each pixel the mean of those that it
/// covers; without other layers.
Image reduced(const Image& image, int width, int height);

}  // namespace lancret
