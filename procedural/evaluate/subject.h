#pragma once
// The groom that an evaluation measures blends on.

#include <optional>
#include <string>
#include <vector>

#include "guides/made/wrapped_curl.h"
#include "procedural/evaluate/hold_out.h"

namespace lancret {

/// The strands that an evaluation splits, and the mesh below them.
struct EvaluationSubject {
    Strands strands;
    std::optional<Scalp> scalp;
    std::optional<TriangleMesh> body;
    std::vector<Polyline> partings;
};

/// Loads a dense groom's strands, wound into curls if `curl` is set. Appends any
/// warnings. Throws InputError.
EvaluationSubject load_subject(const GroomSettings& groom,
                               const std::optional<CurlSettings>& curl,
                               std::vector<std::string>& warnings);

/// hold_out of a groom's subject. Guides are fitted with `segments` helices or, without
/// it, sampled from their strands. Throws InputError.
HoldOut split_groom(const GroomSettings& groom, const EvaluationSubject& subject,
                    std::optional<int> segments);

}  // namespace lancret
