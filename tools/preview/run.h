#pragma once
// The pictures of lancret preview, one after the other.

#include <nlohmann/json_fwd.hpp>

#include "tools/preview/options.h"

namespace lancret {

/// Renders and writes all pictures and the contact sheet. Returns their statistics, for
/// --stats. Throws InputError.
nlohmann::json run_preview(const PreviewOptions& options);

}  // namespace lancret
