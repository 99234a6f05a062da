#include "procedural/bind/report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace lancret {

namespace {

struct BindCounter {
    const char* key;  ///< in JSON
    std::size_t BindReport::*count;
    const char* text;  ///< after "N of M children"
};
constexpr BindCounter kCounters[] = {
    {"no_facing_guide", &BindReport::no_facing_guide,
     "face none of their guides: weights by distance only"},
    {"no_guide_in_reach", &BindReport::no_guide_in_reach,
     "have no guide within the maximum distance and angle: they follow the nearest"},
    {"no_guide_in_sight", &BindReport::no_guide_in_sight,
     "have no guide on their side of a parting: they follow the nearest"},
    {"no_guide_in_region", &BindReport::no_guide_in_region,
     "are in a region without a guide: the guides of all regions are used"},
    {"opposed_root_frames", &BindReport::opposed_root_frames,
     "have guides with opposed root tangents: their mean or the heaviest is used"},
    {"straight_guides", &BindReport::straight_guides,
     "have only straight guides, which have no normal: the guides' first axis is used"},
};

}  // namespace

BindReport& BindReport::operator+=(const BindReport& more) {
    for (const BindCounter& counter : kCounters) {
        this->*counter.count += more.*counter.count;
    }
    return *this;
}

std::string bind_table(const BindReport& report, std::size_t children,
                       std::string_view before) {
    std::string out;
    for (const BindCounter& counter : kCounters) {
        const std::size_t count = report.*counter.count;
        if (count > 0) {
            out += fmt::format("{}{} of {} children {} ({})\n", before, count, children,
                               counter.text, counter.key);
        }
    }
    return out;
}

std::string bind_line(const BindReport& report) {
    std::string out;
    for (const BindCounter& counter : kCounters) {
        out += fmt::format("{}{} {}", out.empty() ? "" : ", ", counter.key,
                           report.*counter.count);
    }
    return out;
}

nlohmann::json bind_json(const BindReport& report) {
    nlohmann::json out;
    for (const BindCounter& counter : kCounters) {
        out[counter.key] = report.*counter.count;
    }
    return out;
}

}  // namespace lancret
