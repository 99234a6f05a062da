#pragma once
// The groom of a preview, opened through the plugin, and its statistics.

#include <memory>
#include <nlohmann/json_fwd.hpp>

#include "render_test/plugin/strands.h"
#include "tools/job.h"

namespace lancret {

/// Opens the groom of a job; shows its stages on a terminal and prints its warnings to
/// stderr. Throws InputError.
std::unique_ptr<PluginGroom> open_groom(const Job& job);

/// Prints fallbacks of binding to stderr.
void print_binding_report(const PluginStrands& strands);

/// The JSON of lancret_groom_describe, plus {strands, intervals, seconds.{load, fit,
/// bind}, bytes.{binding, binding_per_strand}, bind: as of bind_json}. seconds.bind
/// excludes the binding of chunks.
nlohmann::json groom_stats(const PluginGroom& groom, const PluginStrands& strands);

}  // namespace lancret
