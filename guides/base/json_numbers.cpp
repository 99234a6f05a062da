#include "guides/base/json_numbers.h"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

namespace lancret {

nlohmann::json number_json(double value) {
    return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

nlohmann::json frame_json(double frame) {
    if (frame == std::floor(frame)) return std::int64_t(frame);
    return frame;
}

}  // namespace lancret
