#pragma once
// The legend of a check view, drawn into its picture.

#include "render_test/image/image.h"
#include "render_test/trace/check_view.h"

namespace lancret {

/// The positions of a legend's parts in a picture, pixels, y down.
struct LegendLayout {
    int letters = 12;  ///< height
    int top = 0;       ///< of the dark band at the bottom
    int title = 0;     ///< base line of the title
    int bar_x = 0, bar_y = 0, bar_width = 0, bar_height = 0;
    int labels = 0;  ///< base line of the labels
};
LegendLayout legend_layout(int width, int height);

/// Draws a band with the title and the labelled scale, or with named swatches. Pictures
/// too small for text get only the bar.
void draw_legend(Image& image, const CheckView& view);

}  // namespace lancret
