#pragma once
// The check's findings, for people and for programs.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "procedural/check/check.h"

namespace lancret {

/// A readable table: each figure's median, 99th percentile and maximum beside its
/// tolerance, a histogram of the length error, and the ten worst strands. Ends with a
/// line PASS or FAIL.
std::string check_table(const CheckReport& report);

/// {strands, pass, failed, orthogonality.{max, tolerance}, length.{max_relative_error,
/// mean, tolerance}, emitted_length.{...}, distance.{max_cm, tolerance}, root.{...},
/// hull.{outside, asked}, non_finite, outside_bound, histogram, worst: [{strand, ...}]}
nlohmann::json check_json(const CheckReport& report);

}  // namespace lancret
