#include "tools/expand_chunks.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "guides/base/errors.h"
#include "procedural/bind/report.h"
#include "procedural/chunk/chunked_groom.h"
#include "procedural/motion/moving_groom.h"
#include "tools/prepare_groom.h"
#include "tools/progress.h"
#include "tools/stats.h"

namespace lancret {

namespace {

/// Totals over all chunks.
struct ChunkTotals {
    std::size_t strands = 0, points = 0;
    std::size_t largest_chunk = 0;  ///< bytes
    IntervalCounts classes;
    double bind = 0, expand = 0;  ///< s
    BindReport report;
};

ChunkedGroom chunked_with_progress(const GroomSettings& groom,
                                   std::uint32_t chunk_strands) {
    StageLine line;
    ChunkedGroom out = make_chunked_groom(
        groom, chunk_strands, [&](GroomStage stage) { line.show(stage_name(stage)); });
    line.clear();
    log_warnings(out.ready);
    return out;
}

/// Grows every chunk in turn. `pose` moves them if it is not null.
ChunkTotals expand_chunks(const ChunkedGroom& groom, const ClassedGuides& guides,
                          const ScalpPose* pose) {
    ChunkTotals out;
    Curves curves;
    ProgressBar bar("expand");
    for (std::size_t c = 0; c < groom.chunks.size(); ++c) {
        Stopwatch watch;
        Binding binding = bind_chunk(groom, c);
        if (pose) pose_binding(binding, rest_places(binding, groom.ready.placed), *pose);
        out.report += binding.report;
        out.bind += watch.lap();
        expand(binding, guides, groom.ready.groom.expand, curves);
        out.expand += watch.lap();
        out.strands += curves.strands;
        out.points += curves.points.size();
        for (const auto& [intervals, count] : interval_counts(curves)) {
            out.classes[intervals] += count;
        }
        out.largest_chunk = std::max(out.largest_chunk, binding.bytes() + curves.bytes());
        bar.show(double(c + 1) / double(groom.chunks.size()));
    }
    return out;
}

nlohmann::json chunk_stats(const ChunkedGroom& groom, const ChunkTotals& totals) {
    nlohmann::json stats = ready_groom_stats(groom.ready);
    stats["strands"] = totals.strands;
    stats["points"] = totals.points;
    add_class_stats(stats, totals.classes, groom.ready.groom.expand.basis);
    stats["chunks"] = groom.chunks.size();
    stats["bind"] = bind_json(totals.report);
    stats["seconds"]["cut"] = groom.ready.seconds.bind;
    stats["seconds"]["bind"] = totals.bind;
    stats["seconds"]["expand"] = totals.expand;
    stats["bytes"] = {{"places", groom.places.bytes()},
                      {"chunks", groom.chunks.bytes()},
                      {"largest_chunk", totals.largest_chunk}};
    return stats;
}

}  // namespace

void expand_by_chunks(const Job& job, const FrameOptions& frame,
                      std::uint32_t chunk_strands, const std::string& stats_file) {
    const ChosenFrames chosen = chosen_frames(frame, job, false);
    ChunkedGroom groom = chunked_with_progress(job.groom, chunk_strands);
    const RestPlaces rest = prepare_frames(groom.ready, chosen);
    const FrameState state = go_to_frame(groom.ready, rest, chosen, chosen.frames[0]);
    const ChunkTotals out =
        expand_chunks(groom, state.classed, chosen.moves() ? &state.pose : nullptr);
    if (out.strands == 0) {
        throw InputError(fmt::format("{}: density {} leaves none of the {} strands",
                                     job.groom.name, job.groom.density,
                                     groom.chunks.children.size()));
    }
    fmt::print(stderr, "{}", bind_table(out.report, out.strands, "lancret: "));
    write_stats(stats_file, chunk_stats(groom, out));
    fmt::print(
        "{} strands, {} points in {} chunks; cut {:.2f} s, bind {:.2f} s, expand {:.2f} "
        "s: {:.1f} million points/s; largest chunk {:.1f} MB, roots of all chunks {:.0f} "
        "MB, peak {:.0f} MB\n",
        out.strands, out.points, groom.chunks.size(), groom.ready.seconds.bind, out.bind,
        out.expand, double(out.points) / out.expand / 1e6,
        1e-6 * double(out.largest_chunk), 1e-6 * double(groom.bytes()),
        1e-6 * double(peak_rss()));
}

}  // namespace lancret
