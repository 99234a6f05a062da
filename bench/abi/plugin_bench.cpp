// What the C interface costs: every chunk of a groom, bound and expanded, straight from
// the library and through the plugin into a sink that looks at nothing.
//
// Arguments: 0 straight, 1 through the plugin. Peak memory is of the whole process and
// only grows: run each by itself (--benchmark_filter) to compare it.

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <ctime>

#include "procedural/chunked_groom.h"
#include "procedural/groom_source.h"
#include "procedural/lancret_procedural.h"

namespace lancret {
namespace {

const std::string kGroom = "[strands]\ncount = 200000\n";

double cpu_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

void straight(benchmark::State& run) {
    GroomSource source;
    source.text = kGroom;
    const ChunkedGroom groom = make_chunked_groom(read_groom_source(source).groom);
    const Generator& generator = groom.generator;
    const ClassedGuides guides = rest_guides(generator);
    Curves curves;
    for (auto _ : run) {
        for (std::size_t c = 0; c < groom.chunks.size(); ++c) {
            const Binding binding = bind_chunk(groom, c, 1, generator.classes);
            expand(binding, guides, generator.groom.expand, curves);
            benchmark::DoNotOptimize(curves.points.data());
        }
    }
}

lancret_status ignore(void*, const lancret_curves* curves) {
    benchmark::DoNotOptimize(curves->positions[0]);
    return LANCRET_OK;
}

void through_plugin(benchmark::State& run) {
    lancret_context* context = nullptr;
    lancret_groom* groom = nullptr;
    lancret_source source{};
    source.size = sizeof source;
    source.text = kGroom.c_str();
    lancret_info info{};
    info.size = sizeof info;
    if (lancret_create(LANCRET_ABI_VERSION, nullptr, &context) != LANCRET_OK ||
        lancret_open(context, &source, &groom, nullptr, 0) != LANCRET_OK ||
        lancret_get_info(groom, &info) != LANCRET_OK) {
        run.SkipWithError("cannot open the groom");
        return;
    }
    lancret_options options{};
    options.size = sizeof options;
    options.basis = LANCRET_BSPLINE;
    for (auto _ : run) {
        for (lancret_u32 c = 0; c < info.chunks; ++c) {
            if (lancret_expand(groom, c, &options, ignore, nullptr) != LANCRET_OK) {
                run.SkipWithError("cannot expand a chunk");
            }
        }
    }
    lancret_close(groom);
    lancret_destroy(context);
}

void plugin_cost(benchmark::State& run) {
    const double before = cpu_seconds();
    run.range(0) == 0 ? straight(run) : through_plugin(run);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    // With loading, which both do once.
    run.counters["cpu_s"] = cpu_seconds() - before;
    run.counters["peak_MiB"] = double(usage.ru_maxrss) / 1024;
}

BENCHMARK(plugin_cost)
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace lancret
