#pragma once
// The first 128 bytes of a .hair file, for its reader and its writer.

#include <bit>
#include <cstdint>

namespace lancret::hair {

static_assert(std::endian::native == std::endian::little,
              "the file's bytes are read without swapping");

/// The arrays that follow the header, in this order.
enum ArrayFlag : std::uint32_t {
    kSegments = 1,
    kPoints = 2,
    kThickness = 4,
    kTransparency = 8,
    kColours = 16,
    kUvs = 32,  // LuxCore's extension
    kKnownFlags = 63,
};

struct Header {
    char magic[4];
    std::uint32_t strands, points, flags, default_segments;
    float default_thickness, default_transparency, default_colour[3];
    char text[88];
};
static_assert(sizeof(Header) == 128);

}  // namespace lancret::hair
