#include "tools/stats.h"

#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "guides/base/atomic_file.h"
#include "procedural/curves/control_points.h"

namespace lancret {

std::size_t peak_rss() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::size_t(usage.ru_maxrss) * 1024;
}

IntervalCounts interval_counts(const Curves& curves) {
    IntervalCounts out;
    for (const CurveClass& c : curves.classes) {
        out[int(c.segments)] += c.strands;
    }
    return out;
}

void add_class_stats(nlohmann::json& stats, const IntervalCounts& counts,
                     CurveBasis basis) {
    std::size_t strands = 0;
    stats["classes"] = nlohmann::json::array();
    for (const auto& [intervals, count] : counts) {
        stats["classes"].push_back({{"intervals", intervals}, {"strands", count}});
        strands += count;
    }
    const auto finest = stats.at("intervals").get<std::uint32_t>();
    stats["points_alike"] = strands * control_points_of(basis, finest);
}

void add_curve_stats(nlohmann::json& stats, const Curves& curves, double expand_seconds) {
    add_class_stats(stats, interval_counts(curves), curves.basis);
    stats["points"] = curves.points.size();
    stats["seconds"]["expand"] = expand_seconds;
    stats["bytes"]["curves"] = curves.bytes();
    stats["bytes"]["curves_per_strand"] =
        double(curves.bytes()) / double(std::max(1u, curves.strands));
}

void write_json(const std::filesystem::path& path, const nlohmann::json& json) {
    write_beside_and_rename(path, json.dump(2) + "\n");
}

void write_stats(const std::filesystem::path& path, nlohmann::json stats) {
    if (path.empty()) return;
    stats["peak_rss"] = peak_rss();
    write_json(path, stats);
}

}  // namespace lancret
