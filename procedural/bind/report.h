#pragma once
// What binding had to work around, for people and for JSON.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "procedural/bind/binding.h"

namespace lancret {

/// A line for each kind that there is, with the number of children and what is done then;
/// empty where binding had nothing to work around. Lines begin with `before`.
std::string bind_table(const BindReport& report, std::size_t children,
                       std::string_view before = {});

/// All numbers by name, on one line.
std::string bind_line(const BindReport& report);

/// {no_facing_guide, no_guide_in_reach, no_guide_in_sight, no_guide_in_region,
/// opposed_root_frames, straight_guides}: numbers of children.
nlohmann::json bind_json(const BindReport& report);

}  // namespace lancret
