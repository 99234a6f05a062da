#pragma once
// What the colours of a check view mean, drawn into its picture.

#include "render_test/image/image.h"
#include "render_test/trace/check_view.h"

namespace lancret {

/// Where the parts of a legend stand in a picture, pixels, y down.
struct LegendLayout {
    int letters = 12;  ///< height
    int top = 0;       ///< of the dark band along the bottom
    int title = 0;     ///< its base line
    int bar_x = 0, bar_y = 0, bar_width = 0, bar_height = 0;
    int labels = 0;  ///< their base line
};
LegendLayout legend_layout(int width, int height);

/// Draws the band with the title and the scale with its values, or the swatches with
/// their names. Pictures too small for letters have the bar alone.
void draw_legend(Image& image, const CheckView& view);

}  // namespace lancret
