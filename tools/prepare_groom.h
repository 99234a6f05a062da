#pragma once
// Preparing a groom for expansion, with progress, warnings and statistics.

#include <nlohmann/json_fwd.hpp>

#include "procedural/groom/ready_groom.h"

namespace lancret {

/// make_ready_groom with progress, warnings and a binding report on stderr. Throws
/// InputError, also for more control points than 32 bits can index.
ReadyGroom prepare_groom(const GroomSettings& groom);

/// Prints the warnings about a groom's guides to stderr.
void log_warnings(const ReadyGroom& ready);

/// {groom_strands, guides, segments, seconds.{load, fit}, fit.{...}, roots.{...}}.
nlohmann::json fit_stats(const PlacedGuides& placed);

/// fit_stats and {strands, intervals, blend, seconds.bind, bytes.{binding,
/// binding_per_strand}, bind.{...}: bind_json}. Commands add their own seconds and bytes.
nlohmann::json ready_groom_stats(const ReadyGroom& ready);

}  // namespace lancret
