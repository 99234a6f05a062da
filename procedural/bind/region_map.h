#pragma once
// Regions of a scalp: painted as a map, or told strand by strand. The only file of this
// folder that knows OpenImageIO.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

/// The most colours that a painted map may have.
inline constexpr std::size_t kMaxRegions = 4096;

/// A painted map: each colour is a region, numbered from 0 in the order in which they
/// are met, row by row from the top.
struct RegionMap {
    int width = 0, height = 0;
    std::vector<std::uint32_t> regions;  ///< [width * height]
    std::size_t count = 0;               ///< how many there are
};

/// Reads a picture whose colours are regions. Colours are told apart by their 8 bits a
/// channel, alpha among them; nothing is filtered. Throws InputError that names the path:
/// where it cannot be read, and where it has more than kMaxRegions colours, as a picture
/// with noise or soft borders would.
RegionMap read_region_map(const std::filesystem::path& path);

/// The region of the texel that holds `uv`: u to the right, v upwards from the bottom
/// row. Beyond 0..1 the map repeats.
std::uint32_t region_at(const RegionMap& map, const Vec2& uv);

/// Reads the region of each strand: a text of `strands` whole numbers from 0 to 2^32 - 1,
/// a line each, with nothing else but spaces, and comments from # to the end of a line.
/// Lines without a number are passed over. Throws InputError that names the line.
std::vector<std::uint32_t> read_region_ids(const std::filesystem::path& path,
                                           std::size_t strands);

}  // namespace lancret
