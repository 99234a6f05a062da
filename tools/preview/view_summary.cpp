#include "tools/preview/view_summary.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace lancret {

namespace {

struct Extremes {
    float largest = 0;       ///< value of the largest magnitude
    std::size_t strand = 0;  ///< id of its strand
    std::size_t above = 0;   ///< strands with a value above the limit
};

Extremes extremes(const CheckView& view) {
    const float limit = view.scale.clean.value_or(view.scale.high);
    Extremes out;
    for (std::size_t i = 0; i < view.values.strands(); ++i) {
        bool above = false;
        for (const float value : view.values.of(i)) {
            above = above || value > limit;
            if (std::abs(value) > std::abs(out.largest)) {
                out.largest = value;
                out.strand = view.ids.empty() ? i : view.ids[i];
            }
        }
        out.above += above;
    }
    return out;
}

}  // namespace

std::string view_line(const ViewRequest& request, const CheckView& view) {
    if (!has_scale(request.view)) {
        return fmt::format("{} {}", view.title, view.swatches.front().name);
    }
    const Extremes found = extremes(view);
    return fmt::format("{}: largest {:.3g}, strand {}; {} of {} strands above {:.3g}",
                       view.title, found.largest, found.strand, found.above,
                       view.values.strands(), view.scale.clean.value_or(view.scale.high));
}

nlohmann::json view_json(const ViewRequest& request, const CheckView& view) {
    nlohmann::json out{{"name", view_name(request.view)}};
    if (!has_scale(request.view)) return out;
    const Extremes found = extremes(view);
    out.update({{"low", view.scale.low},
                {"high", view.scale.high},
                {"largest", found.largest},
                {"strand", found.strand},
                {"above", found.above}});
    return out;
}

}  // namespace lancret
