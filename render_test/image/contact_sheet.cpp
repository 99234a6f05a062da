#include "render_test/image/contact_sheet.h"

#include <algorithm>
#include <cmath>

#include "render_test/image/draw.h"

namespace lancret {

ContactSheet make_contact_sheet(std::size_t pictures, int width, int height,
                                const Vec3f& background) {
    ContactSheet out;
    out.pictures = std::max<std::size_t>(pictures, 1);
    out.background = background;
    out.every = (out.pictures + kMaxSheetTiles - 1) / kMaxSheetTiles;
    const int tiles = int((out.pictures + out.every - 1) / out.every);
    // The shape nearest to 3:2; empty places count against it.
    constexpr double kShape = 1.5;
    double best = 1e30;
    for (int columns = 1; columns <= std::min(tiles, kMaxSheetColumns); ++columns) {
        const int rows = (tiles + columns - 1) / columns;
        const double shape = double(columns) * width / (double(rows) * height);
        const double flaw = std::abs(std::log(shape / kShape)) +
                            0.5 * (columns * rows - tiles) / double(tiles);
        if (flaw < best) best = flaw, out.columns = columns, out.rows = rows;
    }
    const double scale =
        std::min({1.0, double(kMaxSheetSide / out.columns - kSheetGap) / width,
                  double(kMaxSheetSide / out.rows - kSheetGap) / height});
    out.tile_width = std::max(1, int(scale * width));
    out.tile_height = std::max(1, int(scale * height));
    out.image.width = out.columns * (out.tile_width + kSheetGap) - kSheetGap;
    out.image.height = out.rows * (out.tile_height + kSheetGap) - kSheetGap;
    Eigen::Vector4f black(0, 0, 0, 1);
    out.image.rgba.assign(std::size_t(out.image.width) * out.image.height, black);
    return out;
}

void add_picture(ContactSheet& sheet, std::size_t index, const Image& picture,
                 const std::string& name) {
    if (index % sheet.every != 0) return;
    const int tile = int(index / sheet.every);
    const int x0 = tile % sheet.columns * (sheet.tile_width + kSheetGap);
    const int y0 = tile / sheet.columns * (sheet.tile_height + kSheetGap);
    const Image small = reduced(picture, sheet.tile_width, sheet.tile_height);
    for (int y = 0; y < sheet.tile_height; ++y) {
        for (int x = 0; x < sheet.tile_width; ++x) {
            Eigen::Vector4f pixel = small.rgba[std::size_t(y) * sheet.tile_width + x];
            pixel.head<3>() += (1 - pixel.w()) * sheet.background;
            pixel.w() = 1;
            sheet.image.rgba[std::size_t(y0 + y) * sheet.image.width + x0 + x] = pixel;
        }
    }
    const int letters = std::clamp(sheet.tile_height / 12, 9, 28);
    if (sheet.tile_height < 2 * letters) return;
    // A dark copy behind the light text keeps it readable on any picture.
    for (const int d : {1, 0}) {
        draw_text(sheet.image, x0 + letters / 2 + d, y0 + letters + letters / 3 + d, name,
                  letters, Vec3f::Constant(d ? 0.0f : 0.9f));
    }
}

}  // namespace lancret
