#pragma once
// The results of an evaluation as text and as JSON.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "guides/made/wrapped_curl.h"
#include "procedural/evaluate/evaluation.h"

namespace lancret {

struct EvaluationReport {
    std::string groom;
    std::optional<CurlSettings> curl;
    std::uint64_t seed = 0;
    int intervals = 0;  ///< per child
    std::vector<BlendEvaluation> blends;
};

/// A few lines about the guides, and a table with one row per blend.
std::string evaluation_table(const EvaluationReport& report, const HoldOut& holdout);

/// {groom, seed, curl, strands, flat_strands, guides, segments, intervals, fit, bind,
/// default, blends.NAME.{rms_over_length, place, tip_distance, length_error, curvature,
/// torsion, ns_per_point, code}}.
nlohmann::json evaluation_json(const EvaluationReport& report, const HoldOut& holdout);

}  // namespace lancret
