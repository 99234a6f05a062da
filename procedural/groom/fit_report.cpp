#include "procedural/groom/fit_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "guides/base/quantile.h"

namespace lancret {

nlohmann::json fit_json(const PlacedGuides& placed) {
    std::vector<double> rms;
    for (const FitReport& fit : placed.fits) rms.push_back(fit.rms / fit.length);
    return {
        {"groom_strands", placed.report.groom_strands},
        {"guides", placed.guides.size()},
        {"segments", placed.guides.segments},
        {"fit",
         {{"rms_over_length_median", quantile(rms, 0.5)},
          {"rms_over_length_p95", quantile(rms, 0.95)},
          {"rms_over_length_max", quantile(rms, 1)}}},
        {"roots",
         {{"snapped", placed.report.snapped_roots},
          {"largest_snap_cm", placed.report.largest_snap}}},
    };
}

std::string roots_line(const PlacedGuides& placed) {
    if (placed.report.snapped_roots == 0) return {};
    return fmt::format("moved {} of {} guide roots onto the scalp, by up to {:.3f} cm",
                       placed.report.snapped_roots, placed.guides.size(),
                       placed.report.largest_snap);
}

std::vector<std::string> warning_lines(const PlacedGuides& placed) {
    std::vector<std::string> out = placed.report.warnings;
    std::string roots = roots_line(placed);
    if (!roots.empty()) out.push_back(std::move(roots));
    return out;
}

}  // namespace lancret
