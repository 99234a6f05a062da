// Placing the roots of the made groom's children, and binding them. Arguments: children,
// threads.

#include <benchmark/benchmark.h>

#include "bench/made_hair.h"
#include "bench/memory_fill.h"

namespace lancret {
namespace {

void rate(benchmark::State& run) {
    run.counters["children/s"] = benchmark::Counter(
        double(run.iterations()) * double(run.range(0)), benchmark::Counter::kIsRate);
}

void place_roots(benchmark::State& run) {
    bench::made_guides();
    bench::on_threads(int(run.range(1)), [&] {
        for (auto _ : run) {
            benchmark::DoNotOptimize(bench::made_roots(std::uint32_t(run.range(0))));
        }
    });
    rate(run);
}

void bind_children(benchmark::State& run) {
    const PlacedGuides& guides = bench::made_guides();
    const Roots roots = bench::made_roots(std::uint32_t(run.range(0)));
    std::size_t bytes = 0;
    bench::on_threads(int(run.range(1)), [&] {
        for (auto _ : run) {
            const Binding binding = bind(roots, guides.guides, guides.normals, {});
            benchmark::DoNotOptimize(binding.weights.data());
            bytes = binding.bytes();
        }
    });
    rate(run);
    run.counters["bytes_per_child"] = double(bytes) / double(run.range(0));
}

void sizes(benchmark::internal::Benchmark* bench) {
    bench->ArgNames({"children", "threads"})
        ->ArgsProduct({{10'000, 100'000, 1'000'000}, {1, 2}})
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}
BENCHMARK(place_roots)->Apply(sizes);
BENCHMARK(bind_children)->Apply(sizes);

}  // namespace
}  // namespace lancret
