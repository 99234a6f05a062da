// lancret check: the proof that the children of a groom are what they should be.

#include "procedural/check.h"

#include <fmt/format.h>

#include <memory>

#include "procedural/check_report.h"
#include "tools/command.h"
#include "tools/stats.h"

namespace lancret {

namespace {

struct CheckOptions {
    GroomOptions groom;
    std::string json;
    CheckTolerances tolerances;
    std::optional<double> distance;  ///< none: the groom's own tolerance
};

std::string not_negative(const std::string& text) {
    double value = 0;
    // A NaN is no tolerance either.
    if (CLI::detail::lexical_cast(text, value) && value >= 0) return {};
    return fmt::format("'{}' is no tolerance; give a number from 0 on", text);
}

int check_groom(const CheckOptions& options) {
    const Job job = read_job(options.groom);
    check_output(options.json, {}, options.groom, job.groom);
    check_output(options.groom.stats, {}, options.groom, job.groom, options.json);
    const Generator generator = run_generator(job.groom);
    Stopwatch expand_watch;
    const Curves curves = expand(generator.binding, generator.profiles, job.groom.expand);
    const double expand_seconds = expand_watch.lap();
    Stopwatch check_watch;
    CheckTolerances tolerances = options.tolerances;
    tolerances.distance = options.distance.value_or(job.groom.tolerance);
    const CheckReport report =
        check(generator.binding, generator.source.guides, generator.profiles, curves,
              job.groom.expand.blend, job.groom.bind.length_scale, tolerances);
    const double check_seconds = check_watch.lap();
    fmt::print("{}, blend {}\n{}", job.groom.name, blend_name(job.groom.expand.blend),
               check_table(report));
    if (!options.json.empty()) {
        nlohmann::json json = check_json(report);
        json["groom"] = job.groom.name;
        json["blend"] = blend_name(job.groom.expand.blend);
        write_json(options.json, json);
    }
    nlohmann::json stats = generator_stats(generator);
    add_curve_stats(stats, curves, expand_seconds);
    stats["seconds"]["check"] = check_seconds;
    write_stats(options.groom.stats, std::move(stats));
    return report.pass() ? kFine : kCheckFailed;
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<CheckOptions>();
    CLI::App* command = app.add_subcommand(
        "check", "Prove every strand: frames, length, hull, root, bound");
    add_groom_options(*command, options->groom);
    command->add_option("--json", options->json, "write the report")
        ->type_name("FILE")
        ->check(not_empty());
    CheckTolerances& t = options->tolerances;
    const auto tolerance = [&](const char* name, double& value, const char* what) {
        command->add_option(name, value, what)
            ->type_name("X")
            ->capture_default_str()
            ->check(not_negative);
    };
    tolerance("--orthogonality", t.orthogonality, "of |R^T R - I|");
    tolerance("--length", t.length, "relative, of the strand");
    tolerance("--emitted-length", t.emitted_length, "relative, of the emitted curve");
    command
        ->add_option(
            "--distance", options->distance,
            "cm, of the emitted curve from the strand; the groom's own by default")
        ->type_name("X")
        ->check(CLI::NonNegativeNumber);
    command->footer(
        "Exit code 1 when a strand goes beyond a tolerance.\nExamples:\n"
        "  lancret check examples/made_groom.toml --json report.json\n"
        "  lancret check groom.hair --scalp head.obj --guides 400 --strands 100000\n"
        "  lancret check groom.hair --scalp head.obj --blend position   (to see lengths "
        "drift)");
    command->callback([options, &exit_code] { exit_code = check_groom(*options); });
}

}  // namespace lancret
