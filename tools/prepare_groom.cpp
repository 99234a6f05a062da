#include "tools/prepare_groom.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "procedural/bind/report.h"
#include "procedural/groom/fit_report.h"
#include "tools/job.h"
#include "tools/progress.h"

namespace lancret {

void log_warnings(const ReadyGroom& ready) {
    for (const std::string& warning : warning_lines(ready.placed)) {
        fmt::print(stderr, "lancret: warning: {}\n", warning);
    }
}

ReadyGroom prepare_groom(const GroomSettings& groom) {
    check_points(groom);
    StageLine line;
    ReadyGroom out =
        make_ready_groom(groom, [&](GroomStage stage) { line.show(stage_name(stage)); });
    line.clear();
    std::uint64_t points = 0;
    const std::vector<std::uint32_t> sizes = class_sizes(out.classes, out.binding);
    for (std::size_t c = 0; c < sizes.size(); ++c) {
        points +=
            std::uint64_t(sizes[c]) *
            control_points_of(groom.expand.basis, std::uint32_t(out.classes.counts[c]));
    }
    check_points(groom, out.binding.size(), out.profiles.count, points);
    log_warnings(out);
    fmt::print(stderr, "{}",
               bind_table(out.binding.report, out.binding.size(), "lancret: "));
    return out;
}

nlohmann::json fit_stats(const PlacedGuides& placed) {
    nlohmann::json stats = fit_json(placed);
    stats["seconds"] = {{"load", placed.report.seconds.load},
                        {"fit", placed.report.seconds.fit}};
    return stats;
}

nlohmann::json ready_groom_stats(const ReadyGroom& g) {
    nlohmann::json stats = fit_stats(g.placed);
    stats["strands"] = g.binding.size();
    stats["intervals"] = g.profiles.count;
    stats["blend"] = blend_name(g.groom.expand.blend);
    stats["seconds"]["bind"] = g.seconds.bind;
    stats["bytes"]["binding"] = g.binding.bytes();
    stats["bytes"]["binding_per_strand"] =
        double(g.binding.bytes()) / double(std::max<std::size_t>(1, g.binding.size()));
    stats["bind"] = bind_json(g.binding.report);
    return stats;
}

}  // namespace lancret
