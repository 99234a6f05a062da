#include "guides/fit/guides_of_strands.h"

#include <optional>

#include "guides/base/cancel.h"

namespace lancret {

FittedGuides guides_of_strands(const Strands& strands,
                               std::span<const std::uint32_t> which,
                               std::span<const Vec3> surface_tangents, int segments,
                               int samples, const GuideOfStrand& make) {
    std::vector<std::optional<FittedGuide>> fitted(which.size());
    std::vector<Vec3> roots(which.size());
    cancellable_for(std::size_t(0), which.size(), [&](std::size_t i) {
        const std::optional<Curve> curve = strand_curve(strands, which[i]);
        if (!curve) return;
        const SampledCurve target = resample(*curve, samples);
        const Vec3 hint =
            surface_tangents.empty() ? Vec3(Vec3::UnitX()) : surface_tangents[i];
        fitted[i] = make(target, hint);
        roots[i] = target.positions[0];
    });
    FittedGuides out;
    out.guides.segments = segments;
    for (std::size_t i = 0; i < which.size(); ++i) {
        if (!fitted[i]) {
            ++out.left_out;
            continue;
        }
        const double segment = fitted[i]->report.length / segments;
        out.guides.root_positions.push_back(roots[i]);
        out.guides.root_frames.push_back(fitted[i]->root_frame);
        out.guides.segment_lengths.insert(out.guides.segment_lengths.end(), segments,
                                          segment);
        out.guides.curvatures.insert(out.guides.curvatures.end(),
                                     fitted[i]->curvatures.begin(),
                                     fitted[i]->curvatures.end());
        out.reports.push_back(fitted[i]->report);
        out.strands.push_back(which[i]);
    }
    return out;
}

}  // namespace lancret
