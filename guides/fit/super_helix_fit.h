#pragma once
// Curve to Super-Helix: the n helices that follow a strand best.

#include "guides/fit/guides_of_strands.h"

namespace lancret {

struct FitSettings {
    int segments = 8;             ///< helices per guide, all of one length, >= 1
    int samples_per_segment = 4;  ///< at which the distance is minimised, >= 2
    bool fit_root_frame = true;   ///< the root tangent may turn as well
};

/// The number of samples beyond the root that a strand must have for a fit.
inline int fit_samples(const FitSettings& settings) {
    return settings.segments * settings.samples_per_segment;
}

/// Fits one strand by Levenberg-Marquardt on the curvatures against the sampled
/// positions, with the analytic Jacobian [Bergbom07, Sec. 4.3, generalised from one point
/// to the whole strand]. The root frame is [T, M, T x M], where M is the part of
/// `surface_tangent` across the root tangent T; any direction may be given, even one
/// along T. `target` has fit_samples(settings) + 1 samples.
FittedGuide fit_super_helix(const SampledCurve& target, const Vec3& surface_tangent,
                            const FitSettings& settings);

/// Fits the strands in `which`; see guides_of_strands.
FittedGuides fit_guides(const Strands& strands, std::span<const std::uint32_t> which,
                        std::span<const Vec3> surface_tangents,
                        const FitSettings& settings);

}  // namespace lancret
