// lancret expand: grows the children of a groom and writes or only times them.

#include "tools/subcommands.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "guides/base/errors.h"
#include "guides/files/hair_file.h"
#include "guides/files/hair_file_write.h"
#include "guides/files/mitsuba_file.h"
#include "procedural/chunk/chunks.h"
#include "procedural/expand/child_strands.h"
#include "procedural/expand/expand.h"
#include "procedural/motion/moving_groom.h"
#include "tools/expand_chunks.h"
#include "tools/frames.h"
#include "tools/job.h"
#include "tools/options.h"
#include "tools/prepare_groom.h"
#include "tools/stats.h"

namespace lancret {

namespace {

struct ExpandOptions {
    GroomOptions groom;
    FrameOptions frame;
    std::string output;
    bool chunks = false;
    std::optional<std::uint32_t> chunk_strands;
};

int expand_groom(const ExpandOptions& options) {
    const std::filesystem::path output = options.output;
    const std::string extension = output.extension().string();
    Job job = read_job(options.groom);
    check_output(output, {".hair", ".txt"}, job.inputs);
    check_output(options.groom.stats, {}, job.inputs, output);
    if (options.chunks || options.chunk_strands) {
        if (!output.empty()) {
            throw InputError(
                "--chunks: discards the strands and cannot be combined with -o");
        }
        expand_by_chunks(job, options.frame,
                         options.chunk_strands.value_or(kStrandsPerChunk),
                         options.groom.stats);
        return kFine;
    }
    if (extension == ".txt") {  // requires the same number of points for all strands
        job.groom.expand.basis = CurveBasis::bspline;
        job.groom.adapt = false;
    }
    const ChosenFrames chosen = chosen_frames(options.frame, job, false);
    ReadyGroom ready = prepare_groom(job.groom);
    const RestPlaces rest = prepare_frames(ready, chosen);
    const ClassedGuides guides =
        go_to_frame(ready, rest, chosen, chosen.frames[0]).classed;
    Stopwatch watch;
    const Curves curves = expand(ready.binding, guides, job.groom.expand);
    const double seconds = watch.lap();

    if (extension == ".hair") {
        write_hair(output, child_strands(ready.binding, guides, job.groom.expand));
    } else if (extension == ".txt") {
        write_mitsuba(output, curves.points.span(), curves.points_of(0));
    }
    nlohmann::json stats = ready_groom_stats(ready);
    add_curve_stats(stats, curves, seconds);
    const double alike = stats.at("points_alike").get<double>();
    write_stats(options.groom.stats, std::move(stats));
    fmt::print(
        "{} strands, {} points ({:.0f} % of those without adaptation) in {:.4f} s: "
        "{:.1f} million points/s, {:.0f} bytes per strand{}\n",
        curves.strands, curves.points.size(), 100 * double(curves.points.size()) / alike,
        seconds, double(curves.points.size()) / seconds / 1e6,
        double(curves.bytes()) / curves.strands,
        output.empty() ? "" : "; written to " + output.string());
    return kFine;
}

}  // namespace

void add_expand(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<ExpandOptions>();
    CLI::App* command =
        app.add_subcommand("expand", "Grow the children and write or time them");
    add_groom_options(*command, options->groom);
    add_frame_option(*command, options->frame);
    command
        ->add_option(
            "-o,--output", options->output,
            "file of points on the strands (.hair) or of B-spline control points in "
            "Mitsuba's text format (.txt); default: none")
        ->type_name("FILE")
        ->check(not_empty());
    command->add_flag("--chunks", options->chunks,
                      "grow in chunks and discard them, for any number of strands");
    command
        ->add_option("--chunk-strands", options->chunk_strands,
                     "maximum number of strands per chunk; default: 4096")
        ->type_name("N")
        ->check(CLI::Range(1u, 1'000'000u));
    command->footer(
        "Examples:\n"
        "  lancret expand groom.hair --scalp head.obj --strands 1000000 --stats "
        "time.json\n"
        "  lancret expand groom.toml -o children.hair\n"
        "  lancret expand groom.toml --strands 10000000 --chunks\n"
        "  lancret expand cache.h5 --frame 12 -o children.hair");
    command->callback([options, &exit_code] { exit_code = expand_groom(*options); });
}

}  // namespace lancret
