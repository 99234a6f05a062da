// Expansion of the made groom, compared with the memory bandwidth of the machine.
//
// Arguments: children, intervals per strand (0: the number that a groom chooses by
// itself), threads. A strand of 14 intervals has 17 control points. `fill_share` is the
// rate of bytes written over the bandwidth of a memory fill on the same number of threads
// in the same run. `into_*` writes to the same buffers in each pass, like the fill and
// like successive frames. `anew_*` allocates them in each pass and so includes page
// faults. `scalar_*` uses the scalar blends instead of kernels. `cpu_share` is the same
// ratio by CPU time, spread evenly over the threads; use it if other programs are
// running.

#include <benchmark/benchmark.h>

#include <ctime>

#include "bench/made_hair.h"
#include "bench/memory_fill.h"
#include "guides/base/stopwatch.h"
#include "procedural/expand/expand.h"

namespace lancret {
namespace {

double cpu_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

struct Variant {
    Blend blend;
    bool kernels = true, reallocate = false;
};

void expand_made(benchmark::State& run, Variant variant) {
    const std::uint32_t children = std::uint32_t(run.range(0));
    const int threads = int(run.range(2));
    const double fill = bench::fill_bandwidth(threads);
    const int intervals = run.range(1) > 0 ? int(run.range(1)) : bench::made_intervals();
    const auto profiles = guide_profiles<float>(bench::made_guides().guides, intervals);
    const Binding& binding = bench::made_binding(children);
    const ExpandSettings settings{.blend = variant.blend};
    Curves curves = expand(binding, profiles, settings);
    const std::size_t points = curves.points.size(), bytes = curves.bytes();
    Stopwatch watch;
    double cpu = 0;
    bench::on_threads(threads, [&] {
        watch.lap();
        cpu = cpu_seconds();
        for (auto _ : run) {
            if (variant.reallocate) curves = {};
            const KernelGuides guides =
                variant.kernels
                    ? kernel_guides(profiles, binding.guide_normals, variant.blend)
                    : KernelGuides();
            expand(binding, profiles, guides, settings, curves);
            benchmark::DoNotOptimize(curves.points.data());
        }
        cpu = cpu_seconds() - cpu;
    });
    const double seconds = watch.lap();
    const double runs = double(run.iterations());
    using benchmark::Counter;
    run.counters["points_per_strand"] = double(points) / double(children);
    run.counters["Mpoints/s"] = Counter(runs * double(points) / 1e6, Counter::kIsRate);
    run.counters["bytes/s"] =
        Counter(runs * double(bytes), Counter::kIsRate, Counter::kIs1000);
    run.counters["fill_bytes/s"] = Counter(fill, Counter::kDefaults, Counter::kIs1000);
    run.counters["fill_share"] = runs * double(bytes) / seconds / fill;
    run.counters["cpu_share"] =
        runs * double(bytes) / (cpu / threads) / bench::fill_bandwidths(threads).by_cpu;
    run.counters["cpu_ns_per_point"] = 1e9 * cpu / (runs * double(points));
}

void sizes(benchmark::internal::Benchmark* bench) {
    bench->ArgNames({"children", "intervals", "threads"})
        ->ArgsProduct({{1'000, 10'000, 100'000, 1'000'000}, {14, 0}, {1, 2}})
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}
#define LANCRET_EXPAND(name, ...) \
    BENCHMARK_CAPTURE(expand_made, name, Variant{__VA_ARGS__})->Apply(sizes)
LANCRET_EXPAND(into_position, Blend::position);
LANCRET_EXPAND(into_detail, Blend::detail);
LANCRET_EXPAND(into_option1, Blend::option1);
LANCRET_EXPAND(anew_position, Blend::position, true, true);
LANCRET_EXPAND(anew_detail, Blend::detail, true, true);

void scalar_sizes(benchmark::internal::Benchmark* bench) {
    bench->ArgNames({"children", "intervals", "threads"})
        ->ArgsProduct({{100'000}, {14}, {1, 2}})
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}
#define LANCRET_EXPAND_SCALAR(name, ...) \
    BENCHMARK_CAPTURE(expand_made, name, Variant{__VA_ARGS__})->Apply(scalar_sizes)
LANCRET_EXPAND_SCALAR(scalar_position, Blend::position, false);
LANCRET_EXPAND_SCALAR(scalar_detail, Blend::detail, false);
LANCRET_EXPAND_SCALAR(scalar_option1, Blend::option1, false);

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
