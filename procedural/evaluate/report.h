#pragma once
// What `lancret evaluate` found, as text and as JSON.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "guides/made/wrapped_curl.h"
#include "procedural/evaluate/evaluation.h"
#include "procedural/groom/placed_guides.h"

namespace lancret {

/// The strands that an evaluation takes apart, and the mesh under them.
struct EvaluationSubject {
    Strands strands;
    std::optional<Scalp> scalp;
    std::optional<TriangleMesh> body;
    std::vector<Polyline> partings;
};

/// A dense groom's strands, wound into curls where it is asked for; what is worth telling
/// is added to `warnings`. Throws InputError.
EvaluationSubject load_subject(const GroomSettings& groom,
                               const std::optional<CurlSettings>& curl,
                               std::vector<std::string>& warnings);

/// leave_out of a groom's subject; guides are fitted as `segments` helices, or read.
/// Throws InputError.
HoldOut split_groom(const GroomSettings& groom, const EvaluationSubject& subject,
                    std::optional<int> segments);

/// Everything that a report says.
struct EvaluationReport {
    std::string groom;
    std::optional<CurlSettings> curl;
    std::uint64_t seed = 0;
    int intervals = 0;  ///< of a child
    std::vector<BlendEvaluation> blends;
};

/// What the blends were given: a few lines, and a table with a row a blend.
std::string evaluation_table(const EvaluationReport& report, const HoldOut& taken);

/// {groom, seed, curl, strands, guides, segments, intervals, fit, bind,
/// default, blends.NAME.{rms_over_length, place, tip_distance, length_error, curvature,
/// torsion, ns_per_point}}.
nlohmann::json evaluation_json(const EvaluationReport& report, const HoldOut& taken);

}  // namespace lancret
