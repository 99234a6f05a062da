// Fitting the generated groom's strands. Arguments: segments per guide, threads.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "bench/memory_fill.h"
#include "guides/fit/super_helix_fit.h"
#include "guides/made/made_groom.h"

namespace lancret {
namespace {

void fit_made_groom(benchmark::State& run) {
    constexpr int kStrands = 64;
    MadeGroomSettings made;
    made.strands = kStrands;
    const Strands strands = make_groom(made).strands;
    std::vector<std::uint32_t> which(kStrands);
    std::iota(which.begin(), which.end(), 0u);
    FitSettings settings;
    settings.segments = int(run.range(0));
    std::vector<FitReport> reports;
    bench::on_threads(int(run.range(1)), [&] {
        for (auto _ : run) reports = fit_guides(strands, which, {}, settings).reports;
    });
    std::vector<double> rms;
    for (const FitReport& report : reports) rms.push_back(report.rms / report.length);
    std::ranges::nth_element(rms, rms.begin() + kStrands / 2);
    run.counters["median_rms"] = rms[kStrands / 2];
    run.counters["guides/s"] = benchmark::Counter(double(run.iterations()) * kStrands,
                                                  benchmark::Counter::kIsRate);
}
BENCHMARK(fit_made_groom)
    ->ArgNames({"segments", "threads"})
    ->ArgsProduct({{8, 24}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace lancret
