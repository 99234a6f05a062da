#include "tools/generate.h"

#include <fmt/format.h>

#include <cstdio>
#include <limits>

#include "guides/errors.h"
#include "procedural/bind_report.h"
#include "procedural/fit_report.h"
#include "tools/progress.h"

namespace lancret {

namespace {

void check_points(const Groom& groom, std::uint64_t strands, int intervals,
                  std::uint64_t points) {
    if (points <= std::numeric_limits<std::uint32_t>::max()) return;
    throw InputError(fmt::format(
        "{}: {} strands of {} intervals have {} points, more than 2^32: ask for fewer by "
        "--strands or --intervals",
        groom.name, strands, intervals, points));
}

std::uint64_t points_of(const Groom& groom, std::uint64_t strands, int intervals) {
    return strands * control_points_of(groom.expand.basis, std::uint32_t(intervals));
}

}  // namespace

void check_asked_points(const Groom& groom) {
    const std::uint64_t asked = groom.strands.value_or(1);
    const int least = groom.intervals.value_or(1);
    check_points(groom, asked, least, points_of(groom, asked, least));
}

void tell_warnings(const Generator& generator) {
    for (const std::string& warning : generator.source.warnings) {
        fmt::print(stderr, "lancret: warning: {}\n", warning);
    }
    const std::string roots = roots_line(generator.source);
    if (!roots.empty()) fmt::print(stderr, "lancret: warning: {}\n", roots);
}

Generator run_generator(const Groom& groom) {
    check_asked_points(groom);
    StageLine line;
    Generator out = make_generator(groom, [&](const char* stage) { line.show(stage); });
    line.clear();
    std::uint64_t points = 0;
    const std::vector<std::uint32_t> sizes = class_sizes(out.classes, out.binding);
    for (std::size_t c = 0; c < sizes.size(); ++c) {
        points += points_of(groom, sizes[c], out.classes.counts[c]);
    }
    check_points(groom, out.binding.size(), out.profiles.count, points);
    tell_warnings(out);
    fmt::print(stderr, "{}",
               bind_table(out.binding.report, out.binding.size(), "lancret: "));
    return out;
}

}  // namespace lancret
