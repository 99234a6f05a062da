#pragma once
// Numbers in JSON reports.

#include <nlohmann/json_fwd.hpp>

namespace lancret {

/// `value`, or null if it is not finite, which JSON cannot represent.
nlohmann::json number_json(double value);

/// A frame number, as an integer if it is one.
nlohmann::json frame_json(double frame);

}  // namespace lancret
