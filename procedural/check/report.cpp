#include "procedural/check/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "guides/base/json_numbers.h"
#include "guides/base/worst.h"
#include "procedural/check/figures.h"

namespace lancret {

namespace {

constexpr std::size_t kWorst = 10;

struct Summary {
    double mean = 0, median = 0, p99 = 0, max = 0;
};

Summary summary(const CheckReport& report, float StrandCheck::*value) {
    std::vector<float> sizes;
    sizes.reserve(report.strands.size());
    Summary out;
    for (const StrandCheck& s : report.strands) {
        sizes.push_back(nan_as_infinity(std::abs(s.*value)));
        out.mean += sizes.back();
    }
    if (sizes.empty()) return out;
    out.mean /= double(sizes.size());
    std::ranges::sort(sizes);
    const auto at = [&](double share) {
        return sizes[std::size_t(share * double(sizes.size() - 1))];
    };
    out.median = at(0.5);
    out.p99 = at(0.99);
    out.max = sizes.back();
    return out;
}

/// Number of strands per decade of the relative length error: bin i counts 10^(i - 9) up
/// to 10^(i - 8), the first also everything below, the last everything above.
std::array<std::size_t, 10> length_histogram(const CheckReport& report) {
    std::array<std::size_t, 10> bins{};
    for (const StrandCheck& s : report.strands) {
        const double size = std::abs(s.length_error);
        const double decade = size == 0 ? 0 : std::floor(std::log10(size)) + 9;
        // A NaN is counted in the last bin.
        bins[decade < 9 ? std::size_t(std::max(0.0, decade)) : 9] += 1;
    }
    return bins;
}

template <class Property>
std::size_t count_of(const CheckReport& report, Property property) {
    return std::size_t(std::ranges::count_if(report.strands, property));
}

}  // namespace

std::string check_table(const CheckReport& report) {
    const std::size_t strands = report.strands.size();
    std::string out = fmt::format("{:28} {:>10} {:>10} {:>10} {:>10}\n",
                                  fmt::format("{} strands", strands), "median", "99 %",
                                  "max", "tolerance");
    for (const Figure& figure : kFigures) {
        const Summary s = summary(report, figure.value);
        const double tolerance = report.tolerances.*figure.tolerance;
        out += fmt::format("{:28} {:10.2e} {:10.2e} {:10.2e} {:10.2e}{}\n", figure.title,
                           s.median, s.p99, s.max, tolerance,
                           s.max <= tolerance ? "" : "  <-- above");
    }
    const auto outside_hull = count_of(report, [](auto& s) { return !s.inside_hull; });
    out += fmt::format("kappa and tau outside the guides' hull: {}{}\n", outside_hull,
                       report.hull_applies ? "" : " (does not apply to this blend)");
    out += fmt::format("not finite: {}    tip out of reach: {}\n",
                       count_of(report, [](auto& s) { return !s.finite; }),
                       count_of(report, [](auto& s) { return !s.tip_within_reach; }));

    out += "\nrelative length error, strands\n";
    const auto bins = length_histogram(report);
    const std::size_t fullest = std::max<std::size_t>(1, std::ranges::max(bins));
    for (std::size_t i = 0; i < bins.size(); ++i) {
        const std::string label = i == 0   ? "below 1e-8"
                                  : i == 9 ? "1 or more"
                                           : fmt::format("from 1e{}", int(i) - 9);
        out += fmt::format("  {:10} {:>9} {}\n", label, bins[i],
                           std::string((40 * bins[i] + fullest - 1) / fullest, '#'));
    }

    out += fmt::format("\nworst strands\n{:>10} {:>14} {:>11} {:>11} {:>11} {:>6}\n",
                       "strand", "orthogonality", "length", "emitted", "distance", "");
    for (const StrandCheck& s : report.worst(kWorst)) {
        out += fmt::format("{:>10} {:14.2e} {:11.2e} {:11.2e} {:11.2e} {:>6}\n", s.strand,
                           s.orthogonality, s.length_error, s.emitted_length_error,
                           s.distance, report.passes(s) ? "ok" : "fails");
    }
    const std::size_t failed =
        count_of(report, [&](auto& s) { return !report.passes(s); });
    out += failed == 0
               ? fmt::format("\nPASS: all {} strands keep every tolerance\n", strands)
               : fmt::format("\nFAIL: {} of {} strands exceed a tolerance\n", failed,
                             strands);
    return out;
}

nlohmann::json check_json(const CheckReport& report) {
    nlohmann::json out;
    out["strands"] = report.strands.size();
    out["pass"] = report.pass();
    out["failed"] = count_of(report, [&](auto& s) { return !report.passes(s); });
    for (const Figure& figure : kFigures) {
        const Summary s = summary(report, figure.value);
        out[figure.key] = {{figure.max_key, number_json(s.max)},
                           {"mean", number_json(s.mean)},
                           {"median", number_json(s.median)},
                           {"p99", number_json(s.p99)},
                           {"tolerance", report.tolerances.*figure.tolerance}};
    }
    out["hull"] = {{"outside", count_of(report, [](auto& s) { return !s.inside_hull; })},
                   {"applies", report.hull_applies}};
    out["non_finite"] = count_of(report, [](auto& s) { return !s.finite; });
    out["out_of_reach"] = count_of(report, [](auto& s) { return !s.tip_within_reach; });
    out["length"]["histogram"] = length_histogram(report);
    out["worst"] = nlohmann::json::array();
    for (const StrandCheck& s : report.worst(kWorst)) {
        nlohmann::json entry = {{"strand", s.strand}, {"ok", report.passes(s)}};
        for (const Figure& figure : kFigures) {
            entry[figure.key] = number_json(s.*figure.value);
        }
        out["worst"].push_back(std::move(entry));
    }
    return out;
}

}  // namespace lancret
