#pragma once
// Curve to Super-Helix: the n helices that follow a strand best.

#include <functional>
#include <span>
#include <vector>

#include "guides/helix/guides.h"
#include "guides/strand/curve.h"

namespace lancret {

struct FitSettings {
    int segments = 8;             ///< helices a guide, all of one length, >= 1
    int samples_per_segment = 4;  ///< where the fit is measured, >= 2
    bool fit_root_frame = true;   ///< the root tangent may turn as well
};

/// How near a fit came, over the samples it was measured at.
struct FitReport {
    double length = 0;  ///< cm
    double rms = 0;     ///< cm
    double max = 0;     ///< cm
    int iterations = 0;
};

/// One fitted guide; `Guides` holds rows of them.
struct FittedGuide {
    Mat3 root_frame;
    std::vector<Vec3> curvatures;  ///< [segments], 1/cm, in the root frame carried along
    FitReport report;
};

/// How many samples beyond the root a strand must have for a fit.
inline int fit_samples(const FitSettings& settings) {
    return settings.segments * settings.samples_per_segment;
}

/// Fits one strand by Levenberg-Marquardt on the curvatures against the sampled
/// positions, with the analytic Jacobian [Bergbom07, Sec. 4.3, generalised from one point
/// to the whole strand]. The root frame is [T, M, T x M] with M the part of
/// `surface_tangent` across the root tangent T; any direction serves, also one along T.
/// `target` has fit_samples(settings) + 1 samples.
FittedGuide fit_super_helix(const SampledCurve& target, const Vec3& surface_tangent,
                            const FitSettings& settings);

/// What a set of strands became.
struct FittedGuides {
    Guides guides;
    std::vector<FitReport> reports;      ///< [guides]
    std::vector<std::uint32_t> strands;  ///< [guides] the strand each was fitted to
    std::size_t left_out = 0;            ///< strands without a length
};

/// How a strand becomes a guide, given the surface's tangent at its root.
using GuideOfStrand =
    std::function<FittedGuide(const SampledCurve& target, const Vec3& surface_tangent)>;

/// Makes guides of `segments` of the strands named by `which`, each sampled at `samples`
/// equal steps, by `make`, which is called from several threads at once. The rest as
/// fit_guides.
FittedGuides guides_of_strands(const Strands& strands,
                               std::span<const std::uint32_t> which,
                               std::span<const Vec3> surface_tangents, int segments,
                               int samples, const GuideOfStrand& make);

/// Fits the strands named by `which`, in that order; strands whose points coincide are
/// left out and counted. `surface_tangents` holds the scalp's tangent at each of their
/// roots, or is empty: then the x axis serves. In parallel, with the same result for any
/// number of threads.
FittedGuides fit_guides(const Strands& strands, std::span<const std::uint32_t> which,
                        std::span<const Vec3> surface_tangents,
                        const FitSettings& settings);

}  // namespace lancret
