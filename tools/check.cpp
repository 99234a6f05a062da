// lancret check: the proof that the children of a groom are what they should be.

#include "tools/subcommands.h"

#include <fmt/format.h>

#include <memory>

#include "procedural/bind/report.h"
#include "procedural/check/check.h"
#include "procedural/check/chunks.h"
#include "procedural/check/figures.h"
#include "procedural/check/frames.h"
#include "procedural/check/report.h"
#include "procedural/expand/class_choice.h"
#include "procedural/motion/moving_groom.h"
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
    std::optional<double> distance;  ///< none: the groom's own tolerance
};

/// Wall time of all frames, s, and the curves of the last.
struct FramesCost {
    double expand = 0, check = 0;
    Curves curves;
    ChunkCheck chunks;      ///< the worst over the frames
    AdaptedReport adapted;  ///< likewise
};

/// The children of a frame, kept for the step to the next.
struct KeptFrame {
    double frame = 0;
    Binding binding;
    GuideProfiles<double> profiles;
    std::vector<RigidPose> carriers;

    Moment moment() const { return {&binding, &profiles, carriers}; }
};

KeptFrame kept(const ReadyGroom& ready, const FrameState& state, double frame) {
    const bool rigid = std::holds_alternative<RigidPose>(state.pose);
    const Binding& binding = ready.binding;
    return {frame, binding, guide_profiles<double>(state.guides, ready.profiles.count),
            carriers(state.pose, binding.roots.places, rigid ? 1 : binding.size())};
}

FramesReport check_frames(const CheckOptions& options, const Job& job,
                          const ChosenFrames& chosen, ReadyGroom& ready,
                          FramesCost& cost) {
    CheckTolerances tolerances = options.tolerances;
    tolerances.distance = options.distance.value_or(job.groom.tolerance);
    const RestPlaces rest = prepare_frames(ready, chosen);
    const std::vector<Vec3f>& roots = ready.binding.roots.positions;
    const Chunks chunks =
        make_chunks(roots.size(), [&](std::uint32_t i) { return roots[i]; });
    FramesReport out;
    ProgressBar bar("check");
    std::optional<KeptFrame> before;
    for (const double frame : chosen.frames) {
        const FrameState state = go_to_frame(ready, rest, chosen, frame);
        Stopwatch watch;
        cost.curves = expand(ready.binding, state.classed, job.groom.expand);
        cost.expand += watch.lap();
        CheckReport children =
            check(ready.binding, state.guides, state.classed, cost.curves,
                  job.groom.expand.blend, job.groom.bind.length_scale, tolerances);
        cost.chunks =
            worst_of(cost.chunks, check_chunks(ready.binding, state.classed, cost.curves,
                                               job.groom.expand, chunks));
        if (ready.classes.size() > 1) {
            const AdaptedReport now =
                adapted_report(ready.binding, state.classed,
                               guide_profiles<float>(state.guides, ready.profiles.count),
                               tolerances.distance, job.groom.expand);
            cost.adapted = {std::max(cost.adapted.farthest, now.farthest),
                            std::max(cost.adapted.beyond, now.beyond)};
        }
        GuideCheck guides =
            check_guides(state.guides, ready.placed.guides, state.scalp_roots);
        // Without a rest pose the guides may be anybody's, and are put on the scalp when
        // they are read.
        guides.root_applies = chosen.info.has_rest;
        add_frame(out, frame, std::move(children), guides);
        if (chosen.frames.size() > 1) {
            KeptFrame now = kept(ready, state, frame);
            if (before) {
                add_step(out, before->frame, frame,
                         temporal_check(before->moment(), now.moment(),
                                        job.groom.expand.blend));
            }
            before = std::move(now);
        }
        cost.check += watch.lap();
        bar.show(double(out.frames.size()) / double(chosen.frames.size()));
    }
    return out;
}

int check_groom(const CheckOptions& options) {
    const Job job = read_job(options.groom);
    check_output(options.json, {}, job.inputs);
    check_output(options.groom.stats, {}, job.inputs, options.json);
    const ChosenFrames chosen = chosen_frames(options.frames, job, true);
    ReadyGroom ready = prepare_groom(job.groom);
    FramesCost cost;
    const FramesReport report = check_frames(options, job, chosen, ready, cost);
    const bool cached = !chosen.cache.empty();
    const bool pass =
        (cached ? report.pass() : report.worst.pass()) && cost.chunks.pass();
    fmt::print("{}, blend {}{}\n{}", job.groom.name, blend_name(job.groom.expand.blend),
               cached ? fmt::format(", frame {}, the worst", report.worst_frame) : "",
               check_table(report.worst));
    fmt::print("bind: {}\n", bind_line(ready.binding.report));
    fmt::print("{}{}\n", chunks_line(cost.chunks), cost.chunks.pass() ? "" : "\nFAIL");
    if (ready.classes.size() > 1) {
        fmt::print(
            "points that adapt: {} classes of {} to {} intervals; at most {:.3g} cm from "
            "the strands of {}, {} of {} strands beyond the tolerance\n",
            ready.classes.size(), ready.classes.counts.front(),
            ready.classes.counts.back(), cost.adapted.farthest, ready.profiles.count,
            cost.adapted.beyond, ready.binding.size());
    }
    if (cached) fmt::print("\n{}", frames_table(report));
    if (!options.json.empty()) {
        nlohmann::json json = check_json(report.worst);
        if (cached) json.update(frames_json(report));
        json["groom"] = job.groom.name;
        json["blend"] = blend_name(job.groom.expand.blend);
        json["chunks"] = chunks_json(cost.chunks);
        json["adapt"] = {{"farthest_cm", number_json(cost.adapted.farthest)},
                         {"beyond", cost.adapted.beyond}};
        json["bind"] = bind_json(ready.binding.report);
        write_json(options.json, json);
    }
    nlohmann::json stats = ready_groom_stats(ready);
    add_curve_stats(stats, cost.curves, cost.expand);
    stats["seconds"]["check"] = cost.check;
    if (cached) {
        for (const double frame : chosen.frames)
            stats["frames"].push_back(frame_json(frame));
    }
    write_stats(options.groom.stats, std::move(stats));
    return pass ? kFine : kCheckFailed;
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<CheckOptions>();
    CLI::App* command = app.add_subcommand(
        "check", "Prove every strand: frames, length, hull, root, bound");
    add_groom_options(*command, options->groom);
    add_frames_options(*command, options->frames);
    command->add_option("--json", options->json, "write the report")
        ->type_name("FILE")
        ->check(not_empty());
    CheckTolerances& t = options->tolerances;
    const auto tolerance = [&](const char* name, double& value, const char* what) {
        command->add_option(name, value, what)
            ->type_name("X")
            ->capture_default_str()
            ->check(not_negative());
    };
    tolerance("--orthogonality", t.orthogonality, "of |R^T R - I|");
    tolerance("--length", t.length, "relative, of the strand");
    tolerance("--emitted-length", t.emitted_length, "relative, of the emitted curve");
    command
        ->add_option(
            "--distance", options->distance,
            "cm, of the emitted curve from the strand; the groom's own by default")
        ->type_name("X")
        ->check(not_negative());
    command->footer(
        "Of a cache all frames are checked, its guides too, and how far children move "
        "from frame to frame beside their guides.\n"
        "Exit code 1 when a strand goes beyond a tolerance.\nExamples:\n"
        "  lancret check examples/made_groom.toml --json report.json\n"
        "  lancret check groom.hair --scalp head.obj --guides 400 --strands 100000\n"
        "  lancret check cache.h5 --frames 1-96\n"
        "  lancret check groom.hair --scalp head.obj --blend position   (to see lengths "
        "drift)");
    command->callback([options, &exit_code] { exit_code = check_groom(*options); });
}

}  // namespace lancret
