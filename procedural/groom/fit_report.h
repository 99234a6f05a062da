#pragma once
// How well guides follow the strands that they were fitted to, as JSON.

#include <nlohmann/json_fwd.hpp>

#include "procedural/groom/placed_guides.h"

namespace lancret {

/// {groom_strands, guides, segments, fit.{rms_over_length_median, _p95, _max},
/// roots.{snapped, largest_snap_cm}}.
nlohmann::json fit_json(const PlacedGuides& placed);

/// What is worth telling of the guides' roots; empty where there is nothing.
std::string roots_line(const PlacedGuides& placed);

/// All warnings of a groom, one line each: those of its guides, and `roots_line`.
std::vector<std::string> warning_lines(const PlacedGuides& placed);

}  // namespace lancret
