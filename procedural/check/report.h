#pragma once
// The check of one frame as text and JSON.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "procedural/check/check.h"

namespace lancret {

/// A table of each figure's median, 99th percentile and maximum with its tolerance, a
/// histogram of the length error, and the ten worst strands. Ends with a line PASS or
/// FAIL.
std::string check_table(const CheckReport& report);

/// {strands, pass, failed, orthogonality.{max, tolerance}, length.{max_relative_error,
/// mean, tolerance}, emitted_length.{...}, distance.{max_cm, tolerance}, root.{...},
/// hull.{outside, applies}, non_finite, out_of_reach, histogram, worst: [{strand, ...}]}
nlohmann::json check_json(const CheckReport& report);

}  // namespace lancret
