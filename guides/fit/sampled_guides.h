#pragma once
// Strands read as Super-Helices of many short segments: what a fit is too slow for.

#include <cstdint>
#include <span>

#include "guides/fit/super_helix_fit.h"

namespace lancret {

/// Reads a strand as helices of one length, one from each sample to the next: tangents at
/// the joints are the strand's own, and each twists as brings its chord nearest to the
/// strand's. Exact on a helix; a fit of many segments does better at a few thousand times
/// the time. The root frame is that of fit_super_helix. The report is
/// measured at the joints. `target` has segments + 1 samples.
FittedGuide read_super_helix(const SampledCurve& target, const Vec3& surface_tangent);

/// fit_guides by read_super_helix: linear in time, and the same for any number of
/// threads.
FittedGuides sample_guides(const Strands& strands, std::span<const std::uint32_t> which,
                           std::span<const Vec3> surface_tangents, int segments);

}  // namespace lancret
