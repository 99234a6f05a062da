#pragma once
// From a groom to its strands, for commands that look at more than the curves.

#include <nlohmann/json_fwd.hpp>

#include "procedural/groom/ready_groom.h"

namespace lancret {

/// make_generator with its stages on a terminal and its warnings on stderr. Throws
/// InputError.
Generator run_generator(const Groom& groom);

/// What is worth telling of a groom's guides, on stderr.
void tell_warnings(const Generator& generator);

/// {groom_strands, guides, segments, seconds.{load, fit}, fit.{...}, roots.{...}}.
nlohmann::json fit_stats(const GroomGuides& source);

/// fit_stats and {strands, intervals, blend, seconds.bind, bytes.{binding,
/// binding_per_strand}, bind.{...}: bind_json}. Commands add their own seconds and bytes.
nlohmann::json generator_stats(const Generator& generator);

}  // namespace lancret
