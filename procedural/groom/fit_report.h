#pragma once
// How closely guides follow the strands that they were fitted to, as JSON and text.

#include <nlohmann/json_fwd.hpp>

#include "procedural/groom/placed_guides.h"

namespace lancret {

/// {groom_strands, guides, segments, fit.{rms_over_length_median, _p95, _max},
/// roots.{snapped, largest_snap_cm}}.
nlohmann::json fit_json(const PlacedGuides& placed);

/// A warning about guide roots that were off the scalp; empty if there were none.
std::string roots_line(const PlacedGuides& placed);

/// All warnings of a groom, one line each: those of its guides, and `roots_line`.
std::vector<std::string> warning_lines(const PlacedGuides& placed);

}  // namespace lancret
