#pragma once
// A picture of a hanging rod.

#include <filesystem>

#include "tools/rod/report.h"

namespace lancret {

/// Draws the rod from the side and, if it leaves that plane by more than a hundredth of
/// its length, from the front: the equilibrium dark, the natural shape grey, ticks in
/// units of the length. The side view is perpendicular to the horizontal part of the root
/// tangent, or of n1 if the root is upright. If the report has a release, draws its
/// shapes from pale to dark, the equilibrium in red, and the energies over time below.
/// Throws an InputError that names the path.
void write_rod_plot(const std::filesystem::path& path, const RodReport& report);

}  // namespace lancret
