#pragma once
// The figures of a strand's check, said once for every report.

#include <cmath>
#include <nlohmann/json.hpp>

#include "procedural/check/check.h"

namespace lancret {

/// One figure of a strand, as the reports name it.
struct Figure {
    const char* key;      ///< in JSON
    const char* max_key;  ///< of its maximum there
    const char* title;    ///< in the table
    float StrandCheck::*value;
    double CheckTolerances::*tolerance;
};
inline constexpr Figure kFigures[] = {
    {"orthogonality", "max", "orthogonality |R^T R - I|", &StrandCheck::orthogonality,
     &CheckTolerances::orthogonality},
    {"length", "max_relative_error", "length, relative", &StrandCheck::length_error,
     &CheckTolerances::length},
    {"emitted_length", "max_relative_error", "length as emitted, relative",
     &StrandCheck::emitted_length_error, &CheckTolerances::emitted_length},
    {"distance", "max_cm", "curve from strand, cm", &StrandCheck::distance,
     &CheckTolerances::distance},
    {"root", "max_cm", "curve from its root, cm", &StrandCheck::root_distance,
     &CheckTolerances::root},
};

/// A number as JSON can hold it: what is not finite becomes null.
inline nlohmann::json number_json(double value) {
    return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

/// A frame's number: whole where it is whole.
inline nlohmann::json frame_json(double frame) {
    if (frame == std::floor(frame)) return std::int64_t(frame);
    return frame;
}

}  // namespace lancret
