#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "guides/base/types.h"

namespace lancret {

/// Writes control points as the text of Mitsuba's `bsplinecurve` (and `linearcurve`)
/// shape: one line "x y z r" per point, a blank line between strands. The numbers are the
/// shortest that read back as the same floats.
///
/// `points` holds the strands one after the other, `points_per_strand` each, cm, with the
/// radius as w. Throws InputError if the file cannot be written or a point is not finite,
/// and std::invalid_argument if the points are not whole strands of at least the four
/// points that a cubic needs.
void write_mitsuba(const std::filesystem::path& path, std::span<const Point4f> points,
                   std::size_t points_per_strand);

}  // namespace lancret
