#include "procedural/evaluate/report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "guides/base/json_numbers.h"
#include "procedural/bind/report.h"
#include "procedural/expand/expand.h"

namespace lancret {

namespace {

std::string_view default_blend() { return blend_name(ExpandSettings{}.blend); }

nlohmann::json spread_json(const Spread& spread) {
    return {{"median", number_json(spread.median)}, {"p95", number_json(spread.p95)}};
}

nlohmann::json distribution_json(const DistributionFigures& figures) {
    return {{"w1", number_json(figures.w1)},
            {"mean_ratio", number_json(figures.mean_ratio)}};
}

}  // namespace

std::string evaluation_table(const EvaluationReport& report, const HoldOut& holdout) {
    std::string out =
        fmt::format("{}: {} guides predict {} strands at their own roots\n", report.groom,
                    holdout.guides.size(), holdout.binding.size());
    if (report.curl) {
        out += fmt::format(
            "wound into curls: radius {:.3g} of the length, {:.3g} turns +- {:.3g} %, "
            "random phase\n",
            report.curl->radius, report.curl->turns, 100 * report.curl->jitter);
    }
    out += fmt::format(
        "guides {} {} segments: RMS over length median {:.5f}, p95 {:.5f}; curvature "
        "W1 {:.4f}, mean ratio {:.3f}\n"
        "{} intervals per child; default blend {}\n",
        holdout.fit.fitted ? "fitted with" : "sampled with", holdout.guides.segments,
        holdout.fit.rms.median, holdout.fit.rms.p95, holdout.fit.curvature.w1,
        holdout.fit.curvature.mean_ratio, report.intervals, default_blend());
    out += bind_table(holdout.binding.report, holdout.binding.size()) + '\n';
    out += fmt::format("{:18}{:^17}{:^17}{:^17}{:^18}{:^15}{:^15}{:>8}\n", "",
                       "RMS / length", "place", "tip", "length error", "curvature",
                       "torsion", "cost");
    out += fmt::format(
        "{:18}{:>8}{:>8} {:>8}{:>8} {:>8}{:>8} {:>9}{:>8} {:>7}{:>7} "
        "{:>7}{:>7} {:>7}  {}\n",
        "blend", "median", "p95", "median", "p95", "median", "p95", "mean", "max", "W1",
        "ratio", "W1", "ratio", "ns/pt", "code");
    for (const BlendEvaluation& blend : report.blends) {
        const StrandFigures& f = blend.figures;
        out += fmt::format(
            "{:18}{:8.4f}{:8.4f} {:8.4f}{:8.4f} {:8.4f}{:8.4f} {:9.1e}{:8.1e} "
            "{:7.3f}{:7.3f} {:7.3f}{:7.3f} {:7.1f}  {}\n",
            blend_name(blend.blend), f.rms.median, f.rms.p95, f.place.median, f.place.p95,
            f.tip.median, f.tip.p95, blend.length_error_mean, blend.length_error_max,
            f.curvature.w1, f.curvature.mean_ratio, f.torsion.w1, f.torsion.mean_ratio,
            blend.ns_per_point, blend.code);
    }
    return out;
}

nlohmann::json evaluation_json(const EvaluationReport& report, const HoldOut& holdout) {
    nlohmann::json out = {
        {"groom", report.groom},
        {"seed", report.seed},
        {"strands", holdout.guides.size() + holdout.binding.size()},
        {"flat_strands", holdout.flat_strands},
        {"guides", holdout.guides.size()},
        {"segments", holdout.guides.segments},
        {"intervals", report.intervals},
        {"bind", bind_json(holdout.binding.report)},
        {"fit",
         {{"fitted", holdout.fit.fitted},
          {"rms_over_length", spread_json(holdout.fit.rms)},
          {"curvature", distribution_json(holdout.fit.curvature)}}},
        {"default", default_blend()},
    };
    if (report.curl) {
        out["curl"] = {{"radius", report.curl->radius},
                       {"turns", report.curl->turns},
                       {"jitter", report.curl->jitter}};
    }
    for (const BlendEvaluation& blend : report.blends) {
        const StrandFigures& f = blend.figures;
        out["blends"][std::string(blend_name(blend.blend))] = {
            {"rms_over_length", spread_json(f.rms)},
            {"place", spread_json(f.place)},
            {"tip_distance", spread_json(f.tip)},
            {"length_error",
             {{"mean", number_json(blend.length_error_mean)},
              {"max", number_json(blend.length_error_max)}}},
            {"curvature", distribution_json(f.curvature)},
            {"torsion", distribution_json(f.torsion)},
            {"ns_per_point", number_json(blend.ns_per_point)},
            {"code", blend.code},
        };
    }
    return out;
}

}  // namespace lancret
