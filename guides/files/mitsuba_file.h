#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "guides/base/types.h"

namespace lancret {

/// Writes control points as the text of Mitsuba's `bsplinecurve` (and `linearcurve`)
/// shape: a line "x y z r" a point, a blank line before each strand but the first. The
/// numbers are the shortest that give the same floats back.
///
/// `points` holds the strands one after the other, `points_per_strand` each, cm, with w
/// the radius. Throws InputError where the file cannot be written or a point is not
/// finite, and std::invalid_argument where the points are not whole strands of four or
/// more, which is what a cubic takes.
void write_mitsuba(const std::filesystem::path& path, std::span<const Point4f> points,
                   std::size_t points_per_strand);

}  // namespace lancret
