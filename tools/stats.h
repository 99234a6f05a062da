#pragma once
// Statistics and timings that the subcommands write as JSON.

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>

#include "guides/base/stopwatch.h"
#include "procedural/curves/curves.h"

namespace lancret {

/// The peak resident memory of the process, bytes.
std::size_t peak_rss();

/// The number of strands by interval count, finest first.
using IntervalCounts = std::map<int, std::size_t, std::greater<>>;
IntervalCounts interval_counts(const Curves& curves);

/// Adds `classes`, each {intervals, strands}, and `points_alike`, the number of control
/// points if all strands had the finest interval count. `stats` must have `intervals`.
void add_class_stats(nlohmann::json& stats, const IntervalCounts& counts,
                     CurveBasis basis);

/// add_class_stats, and adds points, seconds.expand, bytes.curves and
/// bytes.curves_per_strand.
void add_curve_stats(nlohmann::json& stats, const Curves& curves, double expand_seconds);

/// Adds peak_rss and calls write_json; no-op if the path is empty. Throws InputError.
void write_stats(const std::filesystem::path& path, nlohmann::json stats);

/// Writes a file atomically. Throws InputError.
void write_json(const std::filesystem::path& path, const nlohmann::json& json);

}  // namespace lancret
