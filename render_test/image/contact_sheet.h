#pragma once
// Many pictures as one, to be taken in at a glance.

#include <string>

#include "render_test/image/image.h"

namespace lancret {

/// Tiles row after row from the top, each with its name.
struct ContactSheet {
    std::size_t pictures = 0;  ///< that there will be
    std::size_t every = 1;     ///< of so many that there is no room, every n-th alone
    int columns = 1, rows = 1;
    int tile_width = 1, tile_height = 1;  ///< pixels
    Vec3f background = Vec3f::Zero();     ///< linear, behind the pictures
    Image image;                          ///< colour alone
};

inline constexpr int kMaxSheetColumns = 16, kMaxSheetTiles = 256;
inline constexpr int kSheetGap = 4;         ///< pixels between tiles
inline constexpr int kMaxSheetSide = 2048;  ///< pixels across and down

/// A sheet for `pictures` (>= 1) pictures of one size, of about the shape of a screen.
/// Tiles are no larger than the pictures.
ContactSheet make_contact_sheet(std::size_t pictures, int width, int height,
                                const Vec3f& background);

/// Puts picture `index` into its place, reduced, with `name` in its upper left corner.
void add_picture(ContactSheet& sheet, std::size_t index, const Image& picture,
                 const std::string& name);

}  // namespace lancret
