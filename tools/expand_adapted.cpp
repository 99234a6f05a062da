#include "tools/expand_adapted.h"

#include <fmt/format.h>

#include <algorithm>

#include "guides/hair_file.h"
#include "procedural/interval_classes.h"
#include "tools/stats.h"

namespace lancret {

void expand_adapted(const Job& job, const Generator& generator,
                    const std::filesystem::path& output, const std::string& stats_file) {
    const ExpandSettings& settings = job.groom.expand;
    const Binding& binding = generator.binding;
    Stopwatch watch;
    const IntervalClasses classes =
        interval_classes(generator.source.guides, generator.profiles.count);
    const auto of_child = child_classes(binding, classes, job.groom.tolerance, settings);
    const double choose = watch.lap();
    const std::vector<Curves> curves =
        expand_by_class(binding, classes, of_child, settings);
    const double seconds = watch.lap();
    double distance = 0;
    for (std::size_t i = 0; i < binding.size(); ++i) {
        distance = std::max(distance,
                            adapted_distance(binding, classes, i, of_child[i], settings));
    }
    if (!output.empty())
        write_hair(output, adapted_strands(binding, classes, of_child, settings));

    const std::size_t all =
        binding.size() * control_points_of(settings.basis, generator.profiles.count);
    std::size_t points = 0, bytes = 0;
    nlohmann::json stats = generator_stats(generator);
    for (std::size_t c = 0; c < classes.size(); ++c) {
        points += curves[c].points.size();
        bytes += curves[c].bytes();
        stats["classes"].push_back(
            {{"intervals", classes.counts[c]}, {"strands", curves[c].strands}});
        if (curves[c].strands > 0)
            fmt::print("{:9} strands of {} intervals\n", curves[c].strands,
                       classes.counts[c]);
    }
    fmt::print(
        "{} points in {:.4f} s, {:.1f} % of the {} of strands alike; {:.0f} bytes a "
        "strand; at most {:.2g} cm from the strands of {} intervals{}\n",
        points, seconds, 100 * double(points) / double(all), all,
        double(bytes) / double(binding.size()), distance, generator.profiles.count,
        output.empty() ? "" : "; written to " + output.string());
    stats["points"] = points;
    stats["points_alike"] = all;
    stats["farthest_cm"] = distance;
    stats["bytes"]["curves"] = bytes;
    stats["seconds"]["choose"] = choose;
    stats["seconds"]["expand"] = seconds;
    write_stats(stats_file, std::move(stats));
}

}  // namespace lancret
