// lancret check: measures every child of a groom against tolerances.

#include "tools/subcommands.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "guides/base/json_numbers.h"
#include "procedural/bind/report.h"
#include "procedural/check/frames_report.h"
#include "procedural/check/groom_check.h"
#include "procedural/check/report.h"
#include "tools/frames.h"
#include "tools/job.h"
#include "tools/options.h"
#include "tools/prepare_groom.h"
#include "tools/progress.h"
#include "tools/stats.h"

namespace lancret {

namespace {

struct CheckOptions {
    GroomOptions groom;
    FrameOptions frames;
    std::string json;
    CheckTolerances tolerances;
    std::optional<double> distance;  ///< unset: the groom's tolerance
};

GroomCheck check_with_progress(ReadyGroom& ready, const ChosenFrames& chosen,
                               const CheckTolerances& tolerances) {
    ProgressBar bar("check");
    return check_groom(ready, chosen, chosen.frames, tolerances,
                       [&](double done) { bar.show(done); });
}

void print_report(const GroomCheck& check, const ReadyGroom& ready, bool cached) {
    const FramesReport& frames = check.frames;
    fmt::print("{}, blend {}{}\n{}", ready.groom.name,
               blend_name(ready.groom.expand.blend),
               cached ? fmt::format(", worst frame {}", frames.worst_frame) : "",
               check_table(frames.worst));
    fmt::print("bind: {}\n", bind_line(ready.binding.report));
    fmt::print("{}{}\n", chunks_line(check.chunks), check.chunks.pass() ? "" : "\nFAIL");
    if (ready.classes.size() > 1) {
        fmt::print(
            "adapted points: {} classes of {} to {} intervals; at most {:.3g} cm from "
            "strands of {} intervals, {} of {} strands beyond the tolerance\n",
            ready.classes.size(), ready.classes.counts.front(),
            ready.classes.counts.back(), check.adapted.farthest, ready.profiles.count,
            check.adapted.beyond, ready.binding.size());
    }
    if (cached) fmt::print("\n{}", frames_table(frames));
}

nlohmann::json report_json(const GroomCheck& check, const ReadyGroom& ready,
                           bool cached) {
    nlohmann::json json = check_json(check.frames.worst);
    if (cached) json.update(frames_json(check.frames));
    json["groom"] = ready.groom.name;
    json["blend"] = blend_name(ready.groom.expand.blend);
    json["chunks"] = chunks_json(check.chunks);
    json["adapt"] = {{"farthest_cm", number_json(check.adapted.farthest)},
                     {"beyond", check.adapted.beyond}};
    json["bind"] = bind_json(ready.binding.report);
    return json;
}

int run_check(const CheckOptions& options) {
    const Job job = read_job(options.groom);
    check_output(options.json, {}, job.inputs);
    check_output(options.groom.stats, {}, job.inputs, options.json);
    const ChosenFrames chosen = chosen_frames(options.frames, job, true);
    ReadyGroom ready = prepare_groom(job.groom);
    CheckTolerances tolerances = options.tolerances;
    tolerances.distance = options.distance.value_or(job.groom.tolerance);
    const GroomCheck check = check_with_progress(ready, chosen, tolerances);
    const bool cached = !chosen.cache.empty();
    print_report(check, ready, cached);
    if (!options.json.empty()) {
        write_json(options.json, report_json(check, ready, cached));
    }
    nlohmann::json stats = ready_groom_stats(ready);
    add_curve_stats(stats, check.curves, check.expand_seconds);
    stats["seconds"]["check"] = check.check_seconds;
    if (cached) {
        for (const double frame : chosen.frames) {
            stats["frames"].push_back(frame_json(frame));
        }
    }
    write_stats(options.groom.stats, std::move(stats));
    return check.pass ? kFine : kCheckFailed;
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<CheckOptions>();
    CLI::App* command = app.add_subcommand(
        "check", "Check every strand: frames, length, curvature hull, root, reach");
    add_groom_options(*command, options->groom);
    add_frames_options(*command, options->frames);
    command->add_option("--json", options->json, "write the report as JSON")
        ->type_name("FILE")
        ->check(not_empty());
    CheckTolerances& t = options->tolerances;
    const auto tolerance = [&](const char* name, double& value, const char* what) {
        command->add_option(name, value, what)
            ->type_name("X")
            ->capture_default_str()
            ->check(not_negative());
    };
    tolerance("--orthogonality", t.orthogonality,
              "tolerance of |R^T R - I| of the frames");
    tolerance("--length", t.length, "tolerance of a strand's length, relative");
    tolerance("--emitted-length", t.emitted_length,
              "tolerance of the emitted curve's length, relative");
    command
        ->add_option(
            "--distance", options->distance,
            "largest distance of the emitted curve from the strand, cm; default: the "
            "groom's tolerance")
        ->type_name("X")
        ->check(not_negative());
    command->footer(
        "For a cache, checks the children and guides of all frames, and how far children "
        "move from frame to frame compared with their guides.\n"
        "The exit code is 1 if a strand exceeds a tolerance.\nExamples:\n"
        "  lancret check examples/made_groom.toml --json report.json\n"
        "  lancret check groom.hair --scalp head.obj --guides 400 --strands 100000\n"
        "  lancret check cache.h5 --frames 1-96\n"
        "  lancret check groom.hair --scalp head.obj --blend position   (lengths "
        "drift)");
    command->callback([options, &exit_code] { exit_code = run_check(*options); });
}

}  // namespace lancret
