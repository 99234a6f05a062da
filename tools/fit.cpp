// lancret fit: fits Super-Helix guides to strands.

#include "tools/subcommands.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "guides/base/errors.h"
#include "guides/files/guide_cache.h"
#include "guides/files/guide_cache_write.h"
#include "tools/job.h"
#include "tools/options.h"
#include "tools/prepare_groom.h"
#include "tools/stats.h"

namespace lancret {

namespace {

struct FitOptions {
    GroomOptions groom;
    std::string output;
};

int fit_groom(const FitOptions& options) {
    const Job job = read_job(options.groom);
    check_output(options.output, {".h5"}, job.inputs);
    check_output(options.groom.stats, {}, job.inputs, options.output);
    const PlacedGuides fitted = place_guides(job.groom);
    if (fitted.fits.empty()) {
        throw InputError(
            fmt::format("{}: contains guides, not strands to fit", job.groom.name));
    }
    std::vector<double> rms, farthest;
    for (const FitReport& fit : fitted.fits) {
        rms.push_back(100 * fit.rms / fit.length);
        farthest.push_back(fit.max);
    }
    std::ranges::sort(rms);
    std::ranges::sort(farthest);
    write_stats(options.groom.stats, fit_stats(fitted));
    fmt::print(
        "{} guides of {} segments from {} strands in {:.2f} s\n"
        "RMS distance over length: median {:.3f} %, p95 {:.3f} %, max {:.3f} %\n"
        "largest distance: median {:.4f} cm, max {:.4f} cm\n",
        fitted.guides.size(), fitted.guides.segments, fitted.report.groom_strands,
        fitted.report.seconds.fit, rms[rms.size() / 2], rms[rms.size() * 95 / 100],
        rms.back(), farthest[farthest.size() / 2], farthest.back());
    if (!options.output.empty()) {
        GuideCacheHeader header;
        header.groom = std::filesystem::absolute(options.groom.input).string();
        write_guide_cache(options.output, header, {&fitted.guides, 1});
        fmt::print("written to {}\n", options.output);
    }
    return kFine;
}

}  // namespace

void add_fit(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<FitOptions>();
    CLI::App* command = app.add_subcommand("fit", "Fit Super-Helix guides to strands");
    add_groom_options(*command, options->groom);
    command->add_option("-o,--output", options->output, "guide cache to write (.h5)")
        ->type_name("FILE")
        ->check(not_empty());
    command->footer(
        "Examples:\n"
        "  lancret fit groom.hair --guides 400 --segments 8 -o guides.h5\n"
        "  lancret preview guides.h5 --scalp head.obj -o head.png");
    command->callback([options, &exit_code] { exit_code = fit_groom(*options); });
}

}  // namespace lancret
