// The made groom in Embree: build, camera rays, a small picture.

#include <benchmark/benchmark.h>
#include <oneapi/tbb/parallel_reduce.h>

#include "bench/made_hair.h"
#include "bench/memory_fill.h"
#include "procedural/expand/expand.h"
#include "render_test/trace/render.h"
#include "tests/procedural/curve_box.h"

namespace lancret {
namespace {

constexpr std::uint32_t kChildren = 20'000;

/// The control points of the groom, and its head.
struct MadeScene {
    Curves curves;
    Camera camera;

    explicit MadeScene(std::uint32_t children) {
        const auto profiles =
            guide_profiles<float>(bench::made_guides().guides, bench::made_intervals());
        curves = expand(bench::made_binding(children), profiles, {});
        camera = framed(test::box_of(curves), {});
    }
    const TriangleMesh* head() const { return &*bench::made_guides().body; }
};

/// Arguments: children.
void build_scene(benchmark::State& run) {
    const MadeScene made(std::uint32_t(run.range(0)));
    std::size_t bytes = 0;
    double seconds = 0;
    for (auto _ : run) {
        const HairScene scene(made.curves);
        bytes = scene.bvh_bytes();
        seconds += scene.build_seconds();
    }
    const double segments = double(made.curves.segments.size());
    run.counters["bvh_seconds"] =
        benchmark::Counter(seconds, benchmark::Counter::kAvgIterations);
    run.counters["bvh_bytes_per_segment"] = double(bytes) / segments;
    run.counters["segments"] = segments;
}
BENCHMARK(build_scene)
    ->ArgName("children")
    ->Arg(10'000)
    ->Arg(100'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// Arguments: threads.
void camera_rays(benchmark::State& run) {
    constexpr int kSide = 512;
    const MadeScene made(kChildren);
    const HairScene scene(made.curves, made.head());
    std::size_t hits = 0;
    bench::on_threads(int(run.range(0)), [&] {
        for (auto _ : run) {
            hits = tbb::parallel_reduce(
                tbb::blocked_range<int>(0, kSide), std::size_t(0),
                [&](const tbb::blocked_range<int>& rows, std::size_t count) {
                    for (int y = rows.begin(); y < rows.end(); ++y) {
                        for (int x = 0; x < kSide; ++x) {
                            const Vec2f place((float(x) + 0.5f) / kSide,
                                              (float(y) + 0.5f) / kSide);
                            count += scene.intersect(made.camera.ray(place)).has_value();
                        }
                    }
                    return count;
                },
                std::plus<>());
        }
    });
    run.counters["rays/s"] = benchmark::Counter(double(run.iterations()) * kSide * kSide,
                                                benchmark::Counter::kIsRate);
    run.counters["hit_share"] = double(hits) / (kSide * kSide);
}
BENCHMARK(camera_rays)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// Arguments: threads.
void small_picture(benchmark::State& run) {
    const MadeScene made(kChildren);
    const HairScene geometry(made.curves, made.head());
    RenderScene scene;
    scene.geometry = &geometry;
    scene.lights = default_lights(made.camera.view(), Vec3f::UnitY());
    RenderSettings settings;
    settings.width = settings.height = 96;
    settings.samples = 4;
    bench::on_threads(int(run.range(0)), [&] {
        for (auto _ : run) {
            benchmark::DoNotOptimize(render(scene, made.camera, settings));
        }
    });
    run.counters["paths/s"] = benchmark::Counter(
        double(run.iterations()) * settings.width * settings.height * settings.samples,
        benchmark::Counter::kIsRate);
}
BENCHMARK(small_picture)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace lancret
