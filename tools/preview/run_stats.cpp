#include "tools/preview/run_stats.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "guides/base/json_numbers.h"
#include "tools/stats.h"

namespace lancret {

void print_picture(const std::filesystem::path& output, const nlohmann::json& groom_stats,
                   std::size_t strands, const PictureCost& cost) {
    const nlohmann::json& seconds = groom_stats.at("seconds");
    fmt::print(
        "{}: {} strands between {} guides; load {:.2f} s, fit {:.2f}, bind {:.2f}, "
        "expand {:.3f}, BVH {:.2f}, render {:.1f} ({:.2f} million rays/s); {:.0f} MB\n",
        output.string(), strands, groom_stats.at("guides").get<std::size_t>(),
        seconds.at("load").get<double>(), seconds.at("fit").get<double>(),
        seconds.at("bind").get<double>() + cost.bind, cost.expand, cost.bvh, cost.render,
        cost.render > 0 ? 1e-6 * double(cost.rays) / cost.render : 0.0,
        double(peak_rss()) / 1e6);
}

nlohmann::json picture_json(double frame, const std::vector<double>& times, bool still,
                            const PictureFiles& files, const PictureCost& cost) {
    return {{"frame", frame_json(frame)},
            {"image", files.picture.string()},
            {"times", times},
            {"still", still},
            {"seconds",
             {{"bind", cost.bind},
              {"expand", cost.expand},
              {"bvh", cost.bvh},
              {"render", cost.render}}}};
}

void add_cost_stats(nlohmann::json& stats, const PictureCost& total) {
    nlohmann::json& bind = stats["seconds"]["bind"];
    bind = bind.get<double>() + total.bind;
    stats["seconds"]["bvh"] = total.bvh;
    stats["seconds"]["render"] = total.render;
    stats["seconds"]["first_picture"] = total.first;
    stats["rays"] = total.rays;
    stats["paths"] = total.paths;
}

void add_memory_stats(nlohmann::json& stats, const ShownTime& moment, std::size_t bvh,
                      std::size_t initial) {
    const Curves& curves = moment.curves;
    nlohmann::json& bytes = stats["bytes"];
    bytes["bvh"] = bvh;
    bytes["per_time"] = curves.bytes() - curves.segments.bytes();
    bytes["widths"] = moment.true_radii.size() * sizeof(float);
    for (const char* part : {"bvh", "per_time", "widths"}) {
        bytes[part + std::string("_per_strand")] =
            bytes[part].get<double>() / double(std::max(1u, curves.strands));
    }
    bytes["process"] = initial;
}

}  // namespace lancret
