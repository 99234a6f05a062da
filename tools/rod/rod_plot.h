#pragma once
// A picture of a hanging rod.

#include <filesystem>

#include "tools/rod/report.h"

namespace lancret {

/// Writes the rod from the side, and from the front where it leaves that plane by a
/// hundredth of its length: the hanging shape dark, the natural one grey, ticks in
/// lengths. The side view looks across the root tangent's horizontal part, or n1's where
/// the root is upright. Of a rod that was let go: its
/// shapes from pale to dark, the equilibrium red, and below them its energies in time.
/// Throws InputError that names the path.
void write_rod_plot(const std::filesystem::path& path, const RodReport& report);

}  // namespace lancret
