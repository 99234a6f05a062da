#pragma once
// The groom that a preview shows, as the plugin gives it; and what that cost.

#include <memory>
#include <nlohmann/json_fwd.hpp>

#include "render_test/plugin/strands.h"
#include "tools/job.h"

namespace lancret {

/// Opens the groom of a job, its stages on a terminal and its warnings on stderr. Throws
/// InputError.
std::unique_ptr<PluginGroom> open_groom(const Job& job);

/// Tells on stderr what binding had to work around.
void print_binding_report(const PluginStrands& strands);

/// lancret_groom_describe's, and {strands, intervals, seconds.{load, fit, bind},
/// bytes.{binding, binding_per_strand}, bind.{...}: bind_json}; seconds.bind without
/// that of the chunks.
nlohmann::json groom_stats(const PluginGroom& groom, const PluginStrands& strands);

}  // namespace lancret
