#pragma once
// What lancret preview reports about its pictures: a line each, and --stats.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "tools/preview/picture.h"
#include "tools/preview/shown_times.h"

namespace lancret {

/// Prints the line of a finished picture; `groom_stats` are those of groom_stats().
void print_picture(const std::filesystem::path& output, const nlohmann::json& groom_stats,
                   std::size_t strands, const PictureCost& cost);

/// {frame, image, times, still, seconds.{bind, expand, bvh, render}} of a picture.
nlohmann::json picture_json(double frame, const std::vector<double>& times, bool still,
                            const PictureFiles& files, const PictureCost& cost);

/// Adds seconds.{bvh, render, first_picture}, rays and paths, and the binding of chunks
/// to seconds.bind.
void add_cost_stats(nlohmann::json& stats, const PictureCost& total);

/// Adds the memory of a picture to stats["bytes"]: bvh, per_time (ids and control points
/// of one time), widths (of thin strands), each also per strand, and process, `initial`:
/// the process before the groom was read.
void add_memory_stats(nlohmann::json& stats, const ShownTime& moment, std::size_t bvh,
                      std::size_t initial);

}  // namespace lancret
