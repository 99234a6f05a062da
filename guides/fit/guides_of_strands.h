#pragma once
// Guides made of strands, by any method that makes one guide of one strand.

#include <functional>
#include <span>
#include <vector>

#include "guides/helix/guides.h"
#include "guides/strand/curve.h"

namespace lancret {

/// Distances of a guide from its strand, at the samples.
struct FitReport {
    double length = 0;  ///< cm
    double rms = 0;     ///< cm
    double max = 0;     ///< cm
    int iterations = 0;
};

/// One guide without its root position.
struct FittedGuide {
    Mat3 root_frame;
    std::vector<Vec3> curvatures;  ///< [segments], 1/cm, in the root frame carried along
    FitReport report;
};

struct FittedGuides {
    Guides guides;
    std::vector<FitReport> reports;      ///< [guides]
    std::vector<std::uint32_t> strands;  ///< [guides] the strand each was fitted to
    std::size_t left_out = 0;            ///< strands without a length
};

/// Makes the guide of a strand, given the surface's tangent at its root.
using GuideOfStrand =
    std::function<FittedGuide(const SampledCurve& target, const Vec3& surface_tangent)>;

/// Makes a guide of `segments` segments of each strand in `which`, in that order, by
/// calling `make` with the strand at `samples` equal steps, from several threads. Strands
/// without a length are left out and counted. `surface_tangents` holds the scalp's
/// tangent at each of their roots, or is empty: the x axis is then used. The result is
/// the same for any number of threads.
FittedGuides guides_of_strands(const Strands& strands,
                               std::span<const std::uint32_t> which,
                               std::span<const Vec3> surface_tangents, int segments,
                               int samples, const GuideOfStrand& make);

}  // namespace lancret
