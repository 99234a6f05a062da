#pragma once
// What `lancret evaluate` found, as text and as JSON.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "guides/wrapped_curl.h"
#include "procedural/evaluation.h"

namespace lancret {

/// Everything that a report says.
struct EvaluationReport {
    std::string groom;
    std::optional<CurlSettings> curl;
    std::uint64_t seed = 0;
    int intervals = 0;  ///< of a child
    std::vector<BlendEvaluation> blends;
};

/// What the blends were given: a few lines, and a table with a row a blend.
std::string evaluation_table(const EvaluationReport& report, const LeaveOut& taken);

/// {groom, seed, curl, strands, guides, segments, intervals, fit, bind,
/// default, blends.NAME.{rms_over_length, place, tip_distance, length_error, curvature,
/// torsion, ns_per_point}}.
nlohmann::json evaluation_json(const EvaluationReport& report, const LeaveOut& taken);

}  // namespace lancret
