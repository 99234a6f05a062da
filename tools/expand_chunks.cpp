#include "tools/expand_chunks.h"

#include <fmt/format.h>

#include <algorithm>

#include "guides/base/errors.h"
#include "procedural/bind/report.h"
#include "procedural/chunk/chunked_groom.h"
#include "procedural/motion/moving_groom.h"
#include "tools/prepare_groom.h"
#include "tools/progress.h"
#include "tools/stats.h"

namespace lancret {

namespace {

/// Of all chunks together.
struct Grown {
    std::size_t strands = 0, points = 0, largest = 0;  ///< the last in bytes, of a chunk
    IntervalCounts classes;
    double bind = 0, expand = 0;  ///< s
    BindReport report;
};

}  // namespace

void expand_by_chunks(const Job& job, const FrameOptions& frame, std::uint32_t most,
                      const std::string& stats_file) {
    const ChosenFrames chosen = chosen_frames(frame, job, false);
    StageLine line;
    ChunkedGroom groom = make_chunked_groom(
        job.groom, most, [&](GroomStage stage) { line.show(stage_name(stage)); });
    line.clear();
    log_warnings(groom.ready);
    const RestPlaces rest = prepare_frames(groom.ready, chosen);
    const FrameState state = go_to_frame(groom.ready, rest, chosen, chosen.frames[0]);
    const bool moved = !chosen.cache.empty();

    Grown out;
    Curves curves;
    ProgressBar bar("expand");
    for (std::size_t c = 0; c < groom.chunks.size(); ++c) {
        Stopwatch watch;
        Binding binding = bind_chunk(groom, c);
        if (moved) {
            pose_binding(binding, rest_places(binding, groom.ready.placed), state.pose);
        }
        out.report += binding.report;
        out.bind += watch.lap();
        expand(binding, state.classed, job.groom.expand, curves);
        out.expand += watch.lap();
        out.strands += curves.strands;
        out.points += curves.points.size();
        for (const CurveClass& own : curves.classes) {
            out.classes[int(own.segments)] += own.strands;
        }
        out.largest = std::max(out.largest, binding.bytes() + curves.bytes());
        bar.show(double(c + 1) / double(groom.chunks.size()));
    }
    if (out.strands == 0) {
        throw InputError(fmt::format("{}: density {} leaves none of the {} strands",
                                     job.groom.name, job.groom.density,
                                     groom.chunks.children.size()));
    }
    fmt::print(stderr, "{}", bind_table(out.report, out.strands, "lancret: "));

    nlohmann::json stats = ready_groom_stats(groom.ready);
    stats["strands"] = out.strands;
    stats["points"] = out.points;
    add_class_stats(stats, out.classes, job.groom.expand.basis);
    stats["chunks"] = groom.chunks.size();
    stats["bind"] = bind_json(out.report);
    stats["seconds"]["cut"] = groom.ready.seconds.bind;
    stats["seconds"]["bind"] = out.bind;
    stats["seconds"]["expand"] = out.expand;
    stats["bytes"] = {{"places", groom.places.bytes()},
                      {"chunks", groom.chunks.bytes()},
                      {"largest_chunk", out.largest}};
    write_stats(stats_file, std::move(stats));
    fmt::print(
        "{} strands, {} points in {} chunks; cut {:.2f} s, bind {:.2f}, expand {:.2f}: "
        "{:.1f} million points a second; a chunk {:.1f} MB, all chunks' roots {:.0f} MB, "
        "peak {:.0f} MB\n",
        out.strands, out.points, groom.chunks.size(), groom.ready.seconds.bind, out.bind,
        out.expand, double(out.points) / out.expand / 1e6, 1e-6 * double(out.largest),
        1e-6 * double(groom.bytes()), 1e-6 * double(peak_rss()));
}

}  // namespace lancret
