#pragma once
// Many pictures on one sheet.

#include <string>

#include "render_test/image/image.h"

namespace lancret {

/// Tiles, row by row from the top, each with its name.
struct ContactSheet {
    std::size_t pictures = 0;  ///< in total
    std::size_t every = 1;     ///< only every n-th picture is shown if there are too many
    int columns = 1, rows = 1;
    int tile_width = 1, tile_height = 1;  ///< pixels
    Vec3f background = Vec3f::Zero();     ///< linear, behind the pictures
    Image image;                          ///< rgba only
};

inline constexpr int kMaxSheetColumns = 16, kMaxSheetTiles = 256;
inline constexpr int kSheetGap = 4;         ///< pixels between tiles
inline constexpr int kMaxSheetSide = 2048;  ///< pixels across and down

/// A sheet for `pictures` (>= 1) pictures of one size, about as wide as 3:2. Tiles are at
/// most as large as the pictures.
ContactSheet make_contact_sheet(std::size_t pictures, int width, int height,
                                const Vec3f& background);

/// Places picture `index`, reduced, with `name` in its upper left corner.
void add_picture(ContactSheet& sheet, std::size_t index, const Image& picture,
                 const std::string& name);

}  // namespace lancret
