// lancret evaluate: measures how well each blend predicts held-out strands of a groom.

#include "render_test/files/write_image.h"
#include "tools/subcommands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>

#include "guides/base/errors.h"
#include "procedural/evaluate/report.h"
#include "procedural/evaluate/subject.h"
#include "tools/evaluate/evaluate_picture.h"
#include "tools/job.h"
#include "tools/options.h"
#include "tools/progress.h"
#include "tools/stats.h"

namespace lancret {

namespace {

struct EvaluateOptions {
    GroomOptions groom;
    std::string blends, curl, json, image, size = "320x400";
    int samples = 16;
};

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> out(1);
    for (const char c : text) {
        if (c == ',') {
            out.emplace_back();
        } else {
            out.back() += c;
        }
    }
    return out;
}

/// The blends in a comma-separated list, without duplicates; all blends if it is empty.
/// Throws InputError.
std::vector<Blend> parse_blends(const std::string& list) {
    std::vector<std::string_view> names;
    std::vector<Blend> out;
    for (const BlendTraits& traits : blends()) {
        names.push_back(traits.name);
        if (list.empty()) out.push_back(traits.blend);
    }
    if (list.empty()) return out;
    for (const std::string& name : split(list)) {
        const auto blend = blend_named(name);
        if (!blend) {
            throw InputError(
                fmt::format("--blend: unknown blend '{}', expected one of {}", name,
                            fmt::join(names, ", ")));
        }
        if (std::ranges::find(out, *blend) == out.end()) out.push_back(*blend);
    }
    return out;
}

/// The curl in "0.02,8,0.1"; nullopt if `text` is empty. Throws InputError.
std::optional<CurlSettings> parse_curl(const std::string& text) {
    if (text.empty()) return std::nullopt;
    const std::vector<std::string> parts = split(text);
    double value[3] = {};
    const double high[3] = {1, kMaxCurlTurns, 1};
    bool good = parts.size() == 3;
    for (std::size_t i = 0; good && i < 3; ++i) {
        const char* const end = parts[i].data() + parts[i].size();
        const auto [stop, error] = std::from_chars(parts[i].data(), end, value[i]);
        good =
            error == std::errc() && stop == end && value[i] >= 0 && value[i] <= high[i];
    }
    if (!good) {
        throw InputError(fmt::format(
            "--curl: invalid curl '{}': expected radius over length (0 to 1), turns (0 "
            "to "
            "{}) and relative jitter of the turns (0 to 1), such as 0.02,8,0.1",
            text, kMaxCurlTurns));
    }
    return CurlSettings{value[0], value[1], value[2]};
}

/// Throws InputError if a panel's size is invalid or the strip would be too wide.
void check_panel_size(const EvaluateOptions& options, std::size_t blends) {
    const int width = parse_size(options.size).first;
    constexpr int kMaxWidth = 65536;
    const int panels = 1 + int(blends);
    if (!options.image.empty() && width * panels > kMaxWidth) {
        throw InputError(
            fmt::format("--size: {} panels of {} pixels exceed the maximum width of {}",
                        panels, width, kMaxWidth));
    }
}

EvaluationSubject load_with_progress(const GroomSettings& groom,
                                     const std::optional<CurlSettings>& curl) {
    StageLine line;
    line.show("load");
    std::vector<std::string> warnings;
    EvaluationSubject out = load_subject(groom, curl, warnings);
    line.clear();
    for (const std::string& warning : warnings) {
        fmt::print(stderr, "lancret: warning: {}\n", warning);
    }
    return out;
}

HoldOut split_with_progress(const GroomSettings& groom, const EvaluationSubject& subject,
                            std::optional<int> segments) {
    StageLine line;
    line.show("split");
    return split_groom(groom, subject, segments);
}

void evaluate_blends(const HoldOut& holdout, const GuideProfiles<float>& profiles,
                     const std::vector<Blend>& blends, EvaluationReport& report) {
    ProgressBar bar("evaluate");
    for (const Blend blend : blends) {
        report.blends.push_back(evaluate_blend(holdout, profiles, blend));
        bar.show(double(report.blends.size()) / double(blends.size()));
    }
}

void warn_of_poor_guides(const std::string& groom, const GuideFit& fit) {
    if (!(fit.curvature.w1 > 0.02 || fit.rms.p95 > 0.01)) return;
    fmt::print(stderr,
               "lancret: warning: {}: the guides do not keep the shape of their own "
               "strands (curvature W1 {:.3f}, RMS over length {:.4f}); the figures "
               "measure that as well as the blends\n",
               groom, fit.curvature.w1, fit.rms.p95);
}

void write_strip(const EvaluateOptions& options, const Job& job,
                 std::optional<TriangleMesh> body, const StripStrands& strands) {
    StripView view{.preview = job.preview,
                   .up = job.groom.scene.up.cast<float>(),
                   .taper = job.groom.expand.taper,
                   .body = std::move(body)};
    RenderSettings& settings = view.preview.render;
    std::tie(settings.width, settings.height) = parse_size(options.size);
    settings.samples = options.samples;
    view.preview.camera.margin = 1;
    ProgressBar bar("render");
    const Image strip =
        evaluation_strip(strands, view, [&](double done) { bar.show(done); });
    write_image(options.image, strip, job.preview.background);
}

int evaluate_groom(const EvaluateOptions& options) {
    const std::vector<Blend> blends = parse_blends(options.blends);
    const std::optional<CurlSettings> curl = parse_curl(options.curl);
    check_panel_size(options, blends.size());
    const Job job = read_job(options.groom);
    check_output(options.json, {}, job.inputs);
    check_output(options.image, {".png"}, job.inputs, options.json);
    EvaluationSubject subject = load_with_progress(job.groom, curl);
    const HoldOut holdout =
        split_with_progress(job.groom, subject, options.groom.segments);
    EvaluationReport report{.groom = job.groom.name,
                            .curl = curl,
                            .seed = job.groom.seed,
                            .intervals = evaluation_intervals(holdout.guides),
                            .blends = {}};
    const auto profiles = guide_profiles<float>(holdout.guides, report.intervals);
    evaluate_blends(holdout, profiles, blends, report);
    warn_of_poor_guides(job.groom.name, holdout.fit);
    fmt::print("{}", evaluation_table(report, holdout));
    std::fflush(stdout);
    if (!options.json.empty()) {
        write_json(options.json, evaluation_json(report, holdout));
    }
    if (!options.image.empty()) {
        write_strip(options, job, std::move(subject.body), {holdout, profiles, blends});
    }
    return kFine;
}

void add_outputs(CLI::App& command, EvaluateOptions& options) {
    command.add_option("--json", options.json, "write the figures")
        ->type_name("FILE")
        ->check(not_empty());
    command
        .add_option("--image", options.image,
                    "render the real strands and each blend's side by side")
        ->type_name("PNG")
        ->check(not_empty());
    command
        .add_option("--size", options.size, "size of a panel of the picture in pixels")
        ->type_name("WxH")
        ->capture_default_str()
        ->check(not_empty());
    command.add_option("--samples", options.samples, "paths per pixel")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(1, 65536));
}

}  // namespace

void add_evaluate(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<EvaluateOptions>();
    GroomOptions& groom = options->groom;
    groom.guides = "5%";
    CLI::App* command = app.add_subcommand(
        "evaluate", "Measure how well each blend predicts held-out strands of a groom");
    command->add_option("groom", groom.input, "a dense groom (.toml or .hair)")
        ->required()
        ->type_name("FILE")
        ->check(not_empty());
    command
        ->add_option("--guides", groom.guides,
                     "number or percentage of its strands that become guides")
        ->type_name("N|P%")
        ->capture_default_str()
        ->check(not_empty());
    command->add_option("--blend", options->blends, "blends to evaluate; default: all")
        ->type_name("NAME,...")
        ->check(not_empty());
    command
        ->add_option("--seed", groom.seed,
                     "random seed of the first guide and of the curls")
        ->type_name("N")
        ->check(seed_number());
    command->add_option("--scalp", groom.scalp, "mesh that the hair grows on")
        ->type_name("OBJ")
        ->check(not_empty());
    command
        ->add_option("--segments", groom.segments,
                     "fit guides with this many helices, as rendering does; default: "
                     "sample them from their strands as finely as needed")
        ->type_name("N")
        ->check(CLI::Range(1, 200));
    command
        ->add_option("--curl", options->curl,
                     "wind every strand into a curl of random phase first: radius over "
                     "length, turns, relative jitter of the turns")
        ->type_name("R,T,J")
        ->check(not_empty());
    command
        ->add_option("--basis", groom.basis,
                     "interpretation of the points in a .hair file")
        ->type_name("NAME")
        ->check(CLI::IsMember({"catmull-rom", "bspline"}));
    add_outputs(*command, *options);
    command->footer(
        "A prediction uses only the root position of a held-out strand.\n"
        "docs/evaluate.md defines the figures.\n"
        "Examples:\n"
        "  lancret evaluate groom.hair\n"
        "  lancret evaluate groom.hair --scalp head.obj --guides 400 --blend "
        "detail,position --json figures.json\n"
        "  lancret evaluate groom.hair --curl 0.02,8,0.1 --image strip.png");
    command->callback([options, &exit_code] { exit_code = evaluate_groom(*options); });
}

}  // namespace lancret
