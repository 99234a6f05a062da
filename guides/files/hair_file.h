#pragma once
// The .hair file (cyHair): strands as flat arrays behind a header of 128 bytes. The
// layout is told in docs/formats.md.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "guides/strand/strands.h"

namespace lancret {

/// What is worth telling of a file that could be read.
struct HairReport {
    std::size_t dropped_strands = 0;     ///< strands of a single point, left out
    std::vector<std::uint32_t> dropped;  ///< which they were in the file, ascending
    std::string text;                    ///< the header's free text
    std::vector<std::string> warnings;   ///< each a line that names the file
};

/// Reads a .hair file; coordinates are taken as they are (cm, no axis is swapped). The
/// file does not tell the basis: it is left at Catmull-Rom for the caller to change.
///
/// Strands of one point are dropped and counted, with their attributes. Bytes after the
/// arrays and unknown array flags are a warning. Throws InputError, which names the byte,
/// where the header and the file's size disagree, where the segments do not add up to the
/// points, where a number is not finite, a point is no place or a thickness is negative,
/// and where no strand is left. No count is trusted before it has been held against the
/// file's size, so a broken file never asks for more memory than a few times its own
/// size.
Strands read_hair(const std::filesystem::path& path, HairReport* report = nullptr);

/// Writes a .hair file with a segments array; read_hair gives the same bits back (but for
/// the basis, which the format cannot hold). Throws InputError where a strand has more
/// than 65,535 segments or the file cannot be written, and std::invalid_argument where
/// the strands are not consistent, none, or one has fewer than two points.
void write_hair(const std::filesystem::path& path, const Strands& strands);

}  // namespace lancret
