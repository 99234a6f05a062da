#pragma once
// From a groom to its strands, for commands that look at more than the curves.

#include <nlohmann/json_fwd.hpp>

#include "procedural/groom/ready_groom.h"

namespace lancret {

/// make_ready_groom with its stages on a terminal and its warnings on stderr. Throws
/// InputError.
ReadyGroom prepare_groom(const GroomSettings& groom);

/// What is worth telling of a groom's guides, on stderr.
void log_warnings(const ReadyGroom& ready);

/// {groom_strands, guides, segments, seconds.{load, fit}, fit.{...}, roots.{...}}.
nlohmann::json fit_stats(const PlacedGuides& placed);

/// fit_stats and {strands, intervals, blend, seconds.bind, bytes.{binding,
/// binding_per_strand}, bind.{...}: bind_json}. Commands add their own seconds and bytes.
nlohmann::json ready_groom_stats(const ReadyGroom& ready);

}  // namespace lancret
