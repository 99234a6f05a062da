// Expansion of the made groom, against what this machine can write.
//
// Arguments: children, intervals a strand (0: as many as a groom takes by itself),
// threads. A strand of 14 intervals has 17 control points. `fill_share` is bytes written
// over the bandwidth of a memory fill on as many threads in the same run. Each pass
// allocates its buffers anew, as a renderer's does, so its time has the page faults in
// it.

#include <benchmark/benchmark.h>

#include "bench/made_hair.h"
#include "bench/memory_fill.h"
#include "procedural/expand.h"
#include "procedural/stopwatch.h"

namespace lancret {
namespace {

void expand_made(benchmark::State& run, Blend blend) {
    const std::uint32_t children = std::uint32_t(run.range(0));
    const int threads = int(run.range(2));
    const double fill = bench::fill_bandwidth(threads);
    const int intervals = run.range(1) > 0 ? int(run.range(1)) : bench::made_intervals();
    const auto profiles = guide_profiles<float>(bench::made_guides().guides, intervals);
    const Binding& binding = bench::made_binding(children);
    ExpandSettings settings;
    settings.blend = blend;
    std::size_t points = 0, bytes = 0;
    Stopwatch watch;
    bench::on_threads(threads, [&] {
        watch.lap();
        for (auto _ : run) {
            const Curves curves = expand(binding, profiles, settings);
            benchmark::DoNotOptimize(curves.points.data());
            points = curves.points.size();
            bytes = curves.bytes();
        }
    });
    const double seconds = watch.lap();
    const double runs = double(run.iterations());
    using benchmark::Counter;
    run.counters["points_a_strand"] = double(points) / double(children);
    run.counters["Mpoints/s"] = Counter(runs * double(points) / 1e6, Counter::kIsRate);
    run.counters["bytes/s"] =
        Counter(runs * double(bytes), Counter::kIsRate, Counter::kIs1000);
    run.counters["fill_bytes/s"] = Counter(fill, Counter::kDefaults, Counter::kIs1000);
    run.counters["fill_share"] = runs * double(bytes) / seconds / fill;
}

void sizes(benchmark::internal::Benchmark* bench) {
    bench->ArgNames({"children", "intervals", "threads"})
        ->ArgsProduct({{10'000, 100'000, 1'000'000}, {14, 0}, {1, 2}})
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}
BENCHMARK_CAPTURE(expand_made, detail, Blend::detail)->Apply(sizes);
BENCHMARK_CAPTURE(expand_made, option1, Blend::option1)->Apply(sizes);
BENCHMARK_CAPTURE(expand_made, position, Blend::position)->Apply(sizes);

void memory_fill(benchmark::State& run) {
    const int threads = int(run.range(0));
    for (auto _ : run) benchmark::DoNotOptimize(bench::fill_bandwidth(threads));
    run.counters["bytes/s"] =
        benchmark::Counter(bench::fill_bandwidth(threads), benchmark::Counter::kDefaults,
                           benchmark::Counter::kIs1000);
}
BENCHMARK(memory_fill)->ArgName("threads")->Arg(1)->Arg(2)->Iterations(1);

}  // namespace
}  // namespace lancret
