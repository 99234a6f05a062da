// lancret evaluate: measures how well each blend predicts held-out strands of a groom.

#include "tools/subcommands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <memory>

#include "guides/base/errors.h"
#include "procedural/evaluate/report.h"
#include "tools/evaluate_picture.h"
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

/// The blends that a list names, each once; all of them where it is empty. Throws
/// InputError.
std::vector<Blend> chosen_blends(const std::string& list) {
    std::vector<std::string_view> all;
    std::vector<Blend> out;
    for (const BlendTraits& entry : blends()) {
        all.push_back(entry.name);
        if (list.empty()) out.push_back(entry.blend);
    }
    if (list.empty()) return out;
    for (const std::string& name : split(list)) {
        const auto blend = blend_named(name);
        if (!blend) {
            throw InputError(fmt::format("--blend: '{}' is no blend; there are {}", name,
                                         fmt::join(all, ", ")));
        }
        if (std::ranges::find(out, *blend) == out.end()) out.push_back(*blend);
    }
    return out;
}

/// "0.02,8,0.1"; throws InputError.
std::optional<CurlSettings> parse_curl(const std::string& text) {
    if (text.empty()) return std::nullopt;
    const std::vector<std::string> parts = split(text);
    double value[3] = {};
    const double most[3] = {1, kMaxCurlTurns, 1};
    bool good = parts.size() == 3;
    for (std::size_t i = 0; good && i < 3; ++i) {
        const char* const end = parts[i].data() + parts[i].size();
        const auto [stop, error] = std::from_chars(parts[i].data(), end, value[i]);
        good =
            error == std::errc() && stop == end && value[i] >= 0 && value[i] <= most[i];
    }
    if (!good) {
        throw InputError(fmt::format(
            "--curl: '{}' is no curl; give radius over length (0 to 1), turns (0 to {}) "
            "and the turns' relative jitter (0 to 1), such as 0.02,8,0.1",
            text, kMaxCurlTurns));
    }
    return CurlSettings{value[0], value[1], value[2]};
}

void write_strip(const EvaluateOptions& options, Job& job, EvaluationSubject& subject,
                 const HoldOut& taken, const GuideProfiles<float>& profiles,
                 const std::vector<Blend>& blends) {
    StripView view{.preview = job.preview,
                   .up = job.groom.scene.up.cast<float>(),
                   .taper = job.groom.expand.taper,
                   .body = std::move(subject.body)};
    RenderSettings& settings = view.preview.render;
    std::tie(settings.width, settings.height) = parse_size(options.size);
    settings.samples = options.samples;
    view.preview.camera.margin = 1;
    ProgressBar bar("render");
    const Image strip = evaluation_strip(taken, profiles, blends, view,
                                         [&](double done) { bar.show(done); });
    write_image(options.image, strip, job.preview.background);
}

int evaluate_groom(const EvaluateOptions& options) {
    const std::vector<Blend> blends = chosen_blends(options.blends);
    const std::optional<CurlSettings> curl = parse_curl(options.curl);
    const auto [width, height] = parse_size(options.size);
    constexpr int kWidest = 65536;
    if (!options.image.empty() && width * (1 + int(blends.size())) > kWidest) {
        throw InputError(fmt::format("--size: {} panels of {} pixels are wider than {}",
                                     1 + blends.size(), width, kWidest));
    }
    Job job = read_job(options.groom);
    check_output(options.json, {}, job.inputs);
    check_output(options.image, {".png"}, job.inputs, options.json);
    Stopwatch watch;
    StageLine line;
    line.show("load");
    std::vector<std::string> warnings;
    EvaluationSubject subject = load_subject(job.groom, curl, warnings);
    line.clear();
    for (const std::string& warning : warnings) {
        fmt::print(stderr, "lancret: warning: {}\n", warning);
    }
    line.show("take apart");
    const HoldOut taken = split_groom(job.groom, subject, options.groom.segments);
    line.clear();
    EvaluationReport report{.groom = job.groom.name,
                            .curl = curl,
                            .seed = job.groom.seed,
                            .intervals = evaluation_intervals(taken.guides),
                            .blends = {}};
    const auto profiles = guide_profiles<float>(taken.guides, report.intervals);
    {
        ProgressBar bar("evaluate");
        for (const Blend blend : blends) {
            report.blends.push_back(evaluate_blend(taken, profiles, blend));
            bar.show(double(report.blends.size()) / double(blends.size()));
        }
    }
    if (taken.fit.curvature.w1 > 0.02 || taken.fit.rms.p95 > 0.01) {
        fmt::print(
            stderr,
            "lancret: warning: {}: the guides do not keep the shape of their own "
            "strands (curvature W1 {:.3f}, RMS over length {:.4f}); the figures say "
            "as much of that as of the blends\n",
            job.groom.name, taken.fit.curvature.w1, taken.fit.rms.p95);
    }
    fmt::print("{}", evaluation_table(report, taken));
    std::fflush(stdout);
    if (!options.json.empty()) write_json(options.json, evaluation_json(report, taken));
    if (!options.image.empty())
        write_strip(options, job, subject, taken, profiles, blends);
    return kFine;
}

}  // namespace

void add_evaluate(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<EvaluateOptions>();
    GroomOptions& groom = options->groom;
    groom.guides = "5%";
    CLI::App* command = app.add_subcommand(
        "evaluate", "Predict a groom's own strands from a few of them, by each blend");
    command->add_option("groom", groom.input, "a dense groom (.toml or .hair)")
        ->required()
        ->type_name("FILE")
        ->check(not_empty());
    command->add_option("--guides", groom.guides, "how many of its strands become guides")
        ->type_name("N|P%")
        ->capture_default_str()
        ->check(not_empty());
    command->add_option("--blend", options->blends, "which blends; all by default")
        ->type_name("NAME,...")
        ->check(not_empty());
    command->add_option("--seed", groom.seed, "of the first guide and of the curls")
        ->type_name("N")
        ->check(seed_number());
    command->add_option("--scalp", groom.scalp, "mesh that the hair grows on")
        ->type_name("OBJ")
        ->check(not_empty());
    command
        ->add_option(
            "--segments", groom.segments,
            "fit guides of so many helices, as rendering does; by default they are "
            "read from their strands as finely as keeps their shape")
        ->type_name("N")
        ->check(CLI::Range(1, 200));
    command
        ->add_option("--curl", options->curl,
                     "wind every strand into a curl of random phase first: radius over "
                     "length, turns, relative jitter of the turns")
        ->type_name("R,T,J")
        ->check(not_empty());
    command->add_option("--basis", groom.basis, "what the points of a .hair file are")
        ->type_name("NAME")
        ->check(CLI::IsMember({"catmull-rom", "bspline"}));
    command->add_option("--json", options->json, "write the figures")
        ->type_name("FILE")
        ->check(not_empty());
    command->add_option("--image", options->image, "truth and each blend side by side")
        ->type_name("PNG")
        ->check(not_empty());
    command->add_option("--size", options->size, "of a panel of the picture, pixels")
        ->type_name("WxH")
        ->capture_default_str()
        ->check(not_empty());
    command->add_option("--samples", options->samples, "paths a pixel")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(1, 65536));
    command->footer(
        "Of a strand that is left out, only its root's position reaches the prediction.\n"
        "docs/evaluate.md says what each figure is.\n"
        "Examples:\n"
        "  lancret evaluate groom.hair\n"
        "  lancret evaluate groom.hair --scalp head.obj --guides 400 --blend "
        "detail,position --json figures.json\n"
        "  lancret evaluate groom.hair --curl 0.02,8,0.1 --image strip.png");
    command->callback([options, &exit_code] { exit_code = evaluate_groom(*options); });
}

}  // namespace lancret
