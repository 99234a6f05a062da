// Cost of the C interface: every chunk of a groom is bound and expanded, directly by the
// library, and through the plugin into a sink that ignores it.
//
// Arguments: 0 direct, 1 through the plugin; 0 a static groom, 1 a moving one at three
// times, which both hold in memory at once. Peak memory is that of the whole process and
// never shrinks, so compare it in separate runs (--benchmark_filter). Compare times with
// --benchmark_enable_random_interleaving, since machines are noisy.

#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <unistd.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "guides/files/guide_cache.h"
#include "guides/files/guide_cache_write.h"
#include "procedural/chunk/chunked_groom.h"
#include "procedural/groom/groom_source.h"
#include "procedural/groom/head_pose.h"
#include "procedural/lancret_procedural.h"
#include "procedural/motion/moving_groom.h"

namespace lancret {
namespace {

const std::string kGroom = "[strands]\ncount = 200000\n";

/// The time of a static groom, and three times of a shutter for a groom whose head turns
/// from frame 1 to 2.
const std::vector<double> kTimes[] = {{0}, {1.25, 1.5, 1.75}};

/// The cache of the moving groom, removed by the destructor.
struct MovingCache {
    std::filesystem::path folder = std::filesystem::temp_directory_path() /
                                   ("lancret_plugin_bench_" + std::to_string(getpid()));
    std::filesystem::path cache = folder / "turn.h5";

    MovingCache() {
        std::filesystem::create_directory(folder);
        const std::filesystem::path toml = folder / "head.toml";
        std::ofstream(toml) << kGroom
                            << "[motion]\nkeys = [{frame = 1}, {frame = 2, "
                               "move = [1, 0, 0], turn = [0, 15, 0]}]\n";
        GroomSource source;
        source.path = toml;
        const SourcedGroom sourced = read_groom_source(source);
        Guides guides = place_guides(sourced.groom).guides;
        const Guides rest = guides;
        GuideCacheWriter writer(cache, {24, 1, toml.string()}, 2, &rest);
        writer.add(rest);
        const auto head =
            std::get<RigidPose>(head_pose(sourced.motion, sourced.groom)(2));
        for (std::size_t g = 0; g < guides.size(); ++g) {
            guides.root_positions[g] = head * guides.root_positions[g];
            guides.root_frames[g] = head.rotation * guides.root_frames[g];
        }
        writer.add(guides);
        writer.finish();
    }
    ~MovingCache() { std::filesystem::remove_all(folder); }
    MovingCache(const MovingCache&) = delete;
    MovingCache& operator=(const MovingCache&) = delete;
};

double cpu_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

/// Everything that all chunks share is computed once, as in the plugin.
void direct(benchmark::State& run, const MovingCache* moving) {
    GroomSource source;
    if (moving) {
        source.path = moving->cache;
    } else {
        source.text = kGroom;
    }
    const SourcedGroom sourced = read_groom_source(source);
    ChunkedGroom groom = make_chunked_groom(sourced.groom);
    ReadyGroom& ready = groom.ready;
    const GroomTimes times =
        groom_times(sourced.groom, head_pose(sourced.motion, sourced.groom));
    std::vector<ClassedGuides> guides;
    std::vector<PosedScalp> scalps;
    if (moving) {
        Binding guides_only;
        guides_only.guide_normals = ready.placed.normals;
        const RestPlaces rest = rest_places(guides_only, ready.placed);
        prepare_frames(ready, times);
        for (const double time : kTimes[1]) {
            scalps.push_back(posed_scalp(rest, times.pose_at(time)));
            pose_binding_on(guides_only, rest, scalps.back());
            guides.push_back(classed_guides(guides_at(times, ready.placed.places, time),
                                            ready.classes, guides_only.guide_normals,
                                            ready.groom.expand.blend));
        }
    } else {
        guides.push_back(rest_guides(ready));
    }
    std::vector<Curves> curves(guides.size());
    for (auto _ : run) {
        for (std::size_t c = 0; c < groom.chunks.size(); ++c) {
            Binding binding = bind_chunk(groom, c, 1, ready.classes);
            const RestPlaces rest =
                moving ? rest_places(binding, ready.placed) : RestPlaces();
            for (std::size_t t = 0; t < guides.size(); ++t) {
                if (moving) pose_binding_on(binding, rest, scalps[t]);
                expand(binding, guides[t], ready.groom.expand, curves[t]);
                benchmark::DoNotOptimize(curves[t].points.data());
            }
        }
    }
}

lancret_status ignore(void*, const lancret_curves* curves) {
    benchmark::DoNotOptimize(curves->positions[0]);
    return LANCRET_OK;
}

void through_plugin(benchmark::State& run, const MovingCache* moving) {
    lancret_context* context = nullptr;
    lancret_groom* groom = nullptr;
    lancret_source source{};
    source.size = sizeof source;
    const std::string path = moving ? moving->cache.string() : "";
    if (moving) {
        source.path = path.c_str();
    } else {
        source.text = kGroom.c_str();
    }
    lancret_groom_info info{};
    info.size = sizeof info;
    if (lancret_context_create(LANCRET_ABI_VERSION, nullptr, &context) != LANCRET_OK ||
        lancret_groom_open(context, &source, &groom, nullptr, 0) != LANCRET_OK ||
        lancret_groom_get_info(groom, &info) != LANCRET_OK) {
        run.SkipWithError("cannot open the groom");
        return;
    }
    lancret_options options{};
    options.size = sizeof options;
    options.basis = LANCRET_BSPLINE;
    options.times = kTimes[moving != nullptr].data();
    options.time_count = kTimes[moving != nullptr].size();
    for (auto _ : run) {
        for (lancret_u32 c = 0; c < info.chunks; ++c) {
            if (lancret_groom_expand_chunk(groom, c, &options, ignore, nullptr) !=
                LANCRET_OK) {
                run.SkipWithError("cannot expand a chunk");
            }
        }
    }
    lancret_groom_close(groom);
    lancret_context_destroy(context);
}

void plugin_cost(benchmark::State& run) {
    std::optional<MovingCache> cache;
    if (run.range(1)) cache.emplace();
    const MovingCache* moving = cache ? &*cache : nullptr;
    const double before = cpu_seconds();
    run.range(0) == 0 ? direct(run, moving) : through_plugin(run, moving);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    // Includes loading, which both do once.
    run.counters["cpu_s"] = cpu_seconds() - before;
    run.counters["peak_MiB"] = double(usage.ru_maxrss) / 1024;
}

BENCHMARK(plugin_cost)
    ->ArgsProduct({{0, 1}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace lancret
