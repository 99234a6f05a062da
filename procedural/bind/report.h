#pragma once
// The report of a binding: how many children needed a fallback, for people, JSON and
// hosts.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace lancret {

/// Numbers of children that binding could not serve as usual, by reason.
struct BindReport {
    /// No guide within reach faces the child; weights fall back to distance only.
    std::size_t no_facing_guide = 0;
    /// No guide within the maximum distance and angle; the child follows the nearest
    /// visible guide.
    std::size_t no_guide_in_reach = 0;
    /// Partings hide all of the nearest kMaxCandidates guides; the child follows the
    /// nearest one.
    std::size_t no_guide_in_sight = 0;
    /// The child's region has no guide; the guides of all regions are used.
    std::size_t no_guide_in_region = 0;
    /// The root tangents of the guides, turned to the child's normal, nearly cancel (mean
    /// shorter than kOpposedTangents), or a guide's normal is opposed to the child's, so
    /// that the smallest rotation between them is not unique. If the mean vanishes, the
    /// heaviest guide's tangent is used.
    std::size_t opposed_root_frames = 0;
    /// All guides are straight and have no Frenet normal; the guides' own first axis is
    /// used, and the child is straight.
    std::size_t straight_guides = 0;

    BindReport& operator+=(const BindReport& more);
};
inline constexpr double kOpposedTangents = 0.1;

/// A counter of BindReport and the field of the same name in `Info`, a C struct such as
/// lancret_chunk_info.
template <class Info>
struct BindCounterField {
    std::size_t BindReport::*counter;
    decltype(Info::no_facing_guide) Info::*field;
};
template <class Info>
inline constexpr BindCounterField<Info> kBindCounterFields[] = {
    {&BindReport::no_facing_guide, &Info::no_facing_guide},
    {&BindReport::no_guide_in_reach, &Info::no_guide_in_reach},
    {&BindReport::no_guide_in_sight, &Info::no_guide_in_sight},
    {&BindReport::no_guide_in_region, &Info::no_guide_in_region},
    {&BindReport::opposed_root_frames, &Info::opposed_root_frames},
    {&BindReport::straight_guides, &Info::straight_guides},
};

/// Lines of text for people, one for each counter above 0, with the fallback that was
/// used; empty if there are none. Each line begins with `before`.
std::string bind_table(const BindReport& report, std::size_t children,
                       std::string_view before = {});

/// All counters by name, on one line.
std::string bind_line(const BindReport& report);

/// All counters, keyed by the names of the members of BindReport.
nlohmann::json bind_json(const BindReport& report);

}  // namespace lancret
