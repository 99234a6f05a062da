#include "procedural/groom/fit_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "guides/base/quantile.h"

namespace lancret {

nlohmann::json fit_json(const PlacedGuides& source) {
    std::vector<double> rms;
    for (const FitReport& fit : source.fits) rms.push_back(fit.rms / fit.length);
    return {
        {"groom_strands", source.groom_strands},
        {"guides", source.guides.size()},
        {"segments", source.guides.segments},
        {"fit",
         {{"rms_over_length_median", quantile(rms, 0.5)},
          {"rms_over_length_p95", quantile(rms, 0.95)},
          {"rms_over_length_max", quantile(rms, 1)}}},
        {"roots",
         {{"snapped", source.snapped_roots}, {"largest_snap_cm", source.largest_snap}}},
    };
}

std::string roots_line(const PlacedGuides& source) {
    if (source.snapped_roots == 0) return {};
    return fmt::format(
        "{} of {} guide roots were off the scalp and were put on it; the farthest moved "
        "{:.3f} cm",
        source.snapped_roots, source.guides.size(), source.largest_snap);
}

std::vector<std::string> warning_lines(const PlacedGuides& source) {
    std::vector<std::string> out = source.warnings;
    std::string roots = roots_line(source);
    if (!roots.empty()) out.push_back(std::move(roots));
    return out;
}

}  // namespace lancret
