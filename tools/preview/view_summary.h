#pragma once
// The figures of a check view in short.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "render_test/trace/check_view.h"
#include "tools/preview/view_request.h"

namespace lancret {

/// The largest figure, its strand, and the number of strands above the limit: as a line,
/// and for --stats.
std::string view_line(const ViewRequest& request, const CheckView& view);
nlohmann::json view_json(const ViewRequest& request, const CheckView& view);

}  // namespace lancret
