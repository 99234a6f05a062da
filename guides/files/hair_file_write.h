#pragma once
// Writing .hair files.

#include <filesystem>

#include "guides/strand/strands.h"

namespace lancret {

/// Writes a .hair file with a segments array. read_hair returns the same bits, except for
/// the basis, which the format cannot store. Throws InputError if a strand has more than
/// 65,535 segments or the file cannot be written, and std::invalid_argument if there are
/// no strands, one has fewer than two points, or the arrays' sizes disagree.
void write_hair(const std::filesystem::path& path, const Strands& strands);

}  // namespace lancret
