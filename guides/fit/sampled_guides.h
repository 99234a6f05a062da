#pragma once
// Strands sampled as Super-Helices of many short segments, for which a fit is too slow.

#include <cstdint>
#include <span>

#include "guides/fit/super_helix_fit.h"

namespace lancret {

/// Converts a strand to helices of equal length, one from each sample to the next. The
/// tangents at the joints are the strand's, and each helix has the twist that brings its
/// chord nearest to the strand's. Exact on a helix; a fit of many segments is closer but
/// takes a few thousand times as long. The root frame is that of fit_super_helix. The
/// report is measured at the joints. `target` has segments + 1 samples.
FittedGuide read_super_helix(const SampledCurve& target, const Vec3& surface_tangent);

/// As fit_guides, with read_super_helix: takes linear time.
FittedGuides sample_guides(const Strands& strands, std::span<const std::uint32_t> which,
                           std::span<const Vec3> surface_tangents, int segments);

}  // namespace lancret
