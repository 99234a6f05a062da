#pragma once
// Reading .hair files (cyHair): a header of 128 bytes, then flat arrays. docs/formats.md
// describes the layout.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "guides/strand/strands.h"

namespace lancret {

/// Non-fatal findings of read_hair.
struct HairReport {
    std::size_t dropped_strands = 0;     ///< strands of a single point, left out
    std::vector<std::uint32_t> dropped;  ///< their numbers in the file, ascending
    std::string text;                    ///< the header's free text
    std::vector<std::string> warnings;   ///< one line each, with the file's name
};

/// Reads a .hair file; coordinates are taken as they are (cm, no axis is swapped). The
/// format does not store the basis: the caller may change it from Catmull-Rom.
///
/// Strands of one point are dropped and counted. Bytes after the arrays and unknown array
/// flags give a warning. Throws InputError with the byte's offset if the header disagrees
/// with the file's size, the segments do not add up to the points, a number is not
/// finite, a coordinate is out of range, a thickness is negative, or no strand is left.
/// Every count is validated against the file's size before it is used, so a damaged file
/// allocates at most a few times its own size.
Strands read_hair(const std::filesystem::path& path, HairReport* report = nullptr);

}  // namespace lancret
