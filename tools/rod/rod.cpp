// lancret rod: analyses one dimensionless rod under its own weight.

#include "tools/subcommands.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "guides/base/errors.h"
#include "sim/equilibrium/modes.h"
#include "tools/options.h"
#include "tools/progress.h"
#include "tools/rod/report.h"
#include "tools/rod/rod_plot.h"
#include "tools/stats.h"

namespace lancret {

namespace {

struct RodOptions {
    RodSetup setup;
    std::vector<double> natural = {0, 0, 0}, tangent = {1, 0, 0}, normal;
    bool statics = false, buckling = false;
    int modes = 0;
    std::optional<double> release, step;
    Integrator integrator = Integrator::bdf2;
    std::string json, picture;
};

/// Checks the output files before anything is computed.
void check_rod_outputs(const RodOptions& options) {
    check_output(options.json, {}, {}, options.picture);
    check_output(options.picture, {".png", ".exr"}, {}, options.json);
}

RodRelease release_of(const RodOptions& options, const HangingRod& rod) {
    ReleaseSettings settings;
    settings.duration = *options.release;
    settings.step = *options.step;
    settings.stepping = to_round_off(options.integrator);
    constexpr double kMaxSteps = 1e8;
    if (settings.duration / settings.step > kMaxSteps) {
        throw InputError(
            fmt::format("--dt: {:g} makes more than {:g} steps in a time of {:g}",
                        settings.step, kMaxSteps, settings.duration));
    }
    ProgressBar bar("releasing");
    return release_rod(rod, settings, [&](double done) { bar.show(done); });
}

RodReport rod_report(const RodOptions& options) {
    RodReport report;
    report.setup = options.setup;
    report.rod = rod_of(report.setup);
    report.equilibrium = rod_equilibrium(report.rod);
    if (options.modes > 0) {
        if (!report.equilibrium.stable) {
            throw InputError("--modes: found no stable equilibrium to vibrate about");
        }
        report.modes = rod_frequencies(report.rod, report.equilibrium.q, options.modes);
    }
    if (options.buckling) {
        // From no weight to well beyond that of hair, for any gamma.
        HangingRod unit = report.rod;
        unit.gravity = -Vec3::UnitZ();
        constexpr std::size_t kMaxChanges = 16;
        report.max_gamma = std::max(1e4, report.setup.gamma);
        report.changes = stability_changes(unit, report.max_gamma, kMaxChanges);
    }
    if (options.release) report.release = release_of(options, report.rod);
    return report;
}

int run_rod(RodOptions options) {
    const auto vector = [](const std::vector<double>& v) {
        return Vec3(v[0], v[1], v[2]);
    };
    options.setup.natural = vector(options.natural);
    options.setup.root_tangent = vector(options.tangent);
    if (!options.normal.empty()) options.setup.root_normal = vector(options.normal);
    check_rod_outputs(options);
    const RodReport report = rod_report(options);
    if (!options.json.empty()) write_json(options.json, rod_json(report));
    if (!options.picture.empty()) write_rod_plot(options.picture, report);
    fmt::print("{}", rod_table(report));
    if (!report.equilibrium.converged) {
        fmt::print(stderr, "lancret: warning: the equilibrium did not converge\n");
        return kCheckFailed;
    }
    if (report.release && !report.release->finished) {
        fmt::print(stderr,
                   "lancret: warning: a step failed at t = {:g}; try a shorter --dt "
                   "or another --integrator\n",
                   report.release->samples.back().time);
        return kCheckFailed;
    }
    return kFine;
}

/// Adds an option of three numbers. rod_of checks their range.
void add_vector(CLI::App& rod, const char* name, std::vector<double>& value,
                const char* description, const char* type) {
    rod.add_option(name, value, description)
        ->delimiter(',')
        ->expected(3)
        ->type_name(type)
        ->check(number_between(-1e300, 1e300).description(""));
}

void add_shape_options(CLI::App& rod, RodOptions& options) {
    RodSetup& setup = options.setup;
    rod.add_option("--gamma", setup.gamma, "weight: rho S g L^3 / EI_1, along -z")
        ->check(number_between(0, kMaxGamma));
    add_vector(rod, "--natural", options.natural, "natural twist and curvatures, times L",
               "K0,K1,K2");
    add_vector(rod, "--root-tangent", options.tangent, "direction of the clamped root",
               "X,Y,Z");
    add_vector(rod, "--root-normal", options.normal,
               "n1, made perpendicular to the tangent; n2 = n0 x n1", "X,Y,Z");
    rod.add_option("--torsion-ratio", setup.torsion_ratio, "GJ / EI_1")
        ->check(number_between(1e-6, 1e9));
    rod.add_option("--bending-ratio", setup.bending_ratio, "EI_2 / EI_1")
        ->check(number_between(1e-6, 1e9));
    rod.add_option("--segments", setup.segments, "number of helices, of equal length")
        ->type_name("N")
        ->check(CLI::Range(1, 200));
}

void add_analysis_options(CLI::App& rod, RodOptions& options) {
    rod.add_flag("--static", options.statics, "the equilibrium shape (always computed)");
    rod.add_option("--modes", options.modes, "the M lowest frequencies about it")
        ->type_name("M")
        ->check(CLI::Range(1, 600));
    rod.add_flag("--buckling", options.buckling,
                 "the values of gamma at which stability is lost or regained");
}

void add_release_options(CLI::App& rod, RodOptions& options) {
    CLI::Option* release =
        rod.add_option("--release", options.release,
                       "release the rod from its natural shape and simulate it for TIME")
            ->type_name("TIME")
            ->check(number_between(1e-12, 1e6));
    CLI::Option* step = rod.add_option("--dt", options.step, "time step of --release")
                            ->type_name("TIME")
                            ->check(number_between(1e-12, 1e6));
    release->needs(step);
    step->needs(release);
    rod.add_option("--integrator", options.integrator,
                   "bdf2 (default), implicit-euler or semi-implicit")
        ->type_name("NAME")
        ->needs(release)
        ->transform(CLI::CheckedTransformer(std::map<std::string, Integrator>{
            {"bdf2", Integrator::bdf2},
            {"implicit-euler", Integrator::implicit_euler},
            {"semi-implicit", Integrator::semi_implicit}}));
    rod.add_option("--damping", options.setup.damping,
                   "mu, a time: --release is damped by K mu q' (default 0)")
        ->needs(release)
        ->type_name("TIME")
        ->check(number_between(0, 1e6));
}

void add_output_options(CLI::App& rod, RodOptions& options) {
    rod.add_option("--json", options.json, "write the full report")
        ->type_name("FILE")
        ->check(not_empty());
    rod.add_option("-o,--output", options.picture, "write a picture (.png, .exr)")
        ->type_name("FILE")
        ->check(not_empty());
}

}  // namespace

void add_rod(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<RodOptions>();
    CLI::App* rod = app.add_subcommand(
        "rod", "Analyse one hanging rod: shape, frequencies, buckling, motion");
    add_shape_options(*rod, *options);
    add_analysis_options(*rod, *options);
    add_release_options(*rod, *options);
    add_output_options(*rod, *options);
    rod->footer(
        "Dimensionless: L = EI_1 = rho S = 1, so frequencies are in sqrt(EI_1 / (rho S "
        "L^4))\nand times in its inverse.\nExamples:\n"
        "  lancret rod --gamma 10 --modes 6\n"
        "  lancret rod --gamma 100 --natural 0,0,6.2832 --root-tangent 0,0,-1 "
        "--root-normal 1,0,0 -o ring.png\n"
        "  lancret rod --root-tangent 0,0,1 --buckling\n"
        "  lancret rod --bending-ratio 1e8 --buckling --segments 40 --json strip.json\n"
        "  lancret rod --gamma 10 --natural 1,0,5 --segments 5 --release 10 --dt 0.001 "
        "-o "
        "energy.png");
    rod->callback([options, &exit_code] { exit_code = run_rod(*options); });
}

}  // namespace lancret
