#pragma once
// What a command did and what it cost.

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "guides/base/stopwatch.h"
#include "procedural/curves/curves.h"

namespace lancret {

/// The largest resident size of the process so far, bytes.
std::size_t peak_rss();

/// Strands by the number of their intervals, finest first.
using IntervalCounts = std::map<int, std::size_t, std::greater<>>;
IntervalCounts interval_counts(const Curves& curves);

/// classes, each {intervals, strands}, and points_alike: how many control points there
/// would be if all strands had the finest.
void add_class_stats(nlohmann::json& stats, const IntervalCounts& counts,
                     CurveBasis basis);

/// add_class_stats, and points, seconds.expand, bytes.curves and bytes.curves_per_strand.
void add_curve_stats(nlohmann::json& stats, const Curves& curves, double expand_seconds);

/// Writes `json` beside and then renamed, after adding peak_rss; does nothing for an
/// empty path. Throws InputError.
void write_stats(const std::filesystem::path& path, nlohmann::json stats);
void write_json(const std::filesystem::path& path, const nlohmann::json& json);

}  // namespace lancret
