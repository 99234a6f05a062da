#pragma once
// Regions of a scalp: a painted map, or one number per strand. The only file of this
// folder that uses OpenImageIO.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

/// Maximum number of colours in a painted map.
inline constexpr std::size_t kMaxRegions = 4096;

/// A painted map: each colour is a region, numbered from 0 in order of first occurrence,
/// row by row from the top.
struct RegionMap {
    int width = 0, height = 0;
    std::vector<std::uint32_t> regions;  ///< [width * height]
    std::size_t count = 0;               ///< number of regions
};

/// Reads an image whose colours are regions. Colours are compared with 8 bits per
/// channel, including alpha, without filtering. Throws InputError, which names the path,
/// if the image cannot be read, or if it has more than kMaxRegions colours, as an image
/// with noise or soft borders has.
RegionMap read_region_map(const std::filesystem::path& path);

/// The region of the texel at `uv`: u to the right, v upwards from the bottom row. The
/// map repeats outside 0..1.
std::uint32_t region_at(const RegionMap& map, const Vec2& uv);

/// Reads the region of each strand from a text file: `strands` whole numbers from 0 to
/// 2^32 - 1, one per line. Spaces, empty lines and comments from # to the end of a line
/// are ignored. Throws InputError, which names path and line.
std::vector<std::uint32_t> read_region_ids(const std::filesystem::path& path,
                                           std::size_t strands);

}  // namespace lancret
