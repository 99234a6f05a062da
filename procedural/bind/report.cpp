#include "procedural/bind/report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace lancret {

namespace {

struct Fallback {
    const char* key;
    std::size_t BindReport::*count;
    const char* text;
};
constexpr Fallback kFallbacks[] = {
    {"no_facing_guide", &BindReport::no_facing_guide,
     "face none of their guides: weights by distance alone"},
    {"no_guide_in_reach", &BindReport::no_guide_in_reach,
     "have no guide within the greatest distance and angle: they follow the nearest"},
    {"no_guide_in_sight", &BindReport::no_guide_in_sight,
     "have no guide on their side of a parting: they follow the nearest"},
    {"no_guide_in_region", &BindReport::no_guide_in_region,
     "stand in a region without a guide: guides of all regions serve"},
    {"opposed_root_frames", &BindReport::opposed_root_frames,
     "have guides whose roots point apart: the mean, or the heaviest, leads"},
    {"straight_guides", &BindReport::straight_guides,
     "have straight guides only, without a normal: the guides' own axis serves"},
};

}  // namespace

std::string bind_table(const BindReport& report, std::size_t children,
                       std::string_view before) {
    std::string out;
    for (const Fallback& fallback : kFallbacks) {
        const std::size_t count = report.*fallback.count;
        if (count > 0) {
            out += fmt::format("{}{} of {} children {} ({})\n", before, count, children,
                               fallback.text, fallback.key);
        }
    }
    return out;
}

std::string bind_line(const BindReport& report) {
    std::string out;
    for (const Fallback& fallback : kFallbacks) {
        out += fmt::format("{}{} {}", out.empty() ? "" : ", ", fallback.key,
                           report.*fallback.count);
    }
    return out;
}

nlohmann::json bind_json(const BindReport& report) {
    nlohmann::json out;
    for (const Fallback& fallback : kFallbacks) {
        out[fallback.key] = report.*fallback.count;
    }
    return out;
}

}  // namespace lancret
