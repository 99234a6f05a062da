#include <benchmark/benchmark.h>

#include "guides/helix/helix.h"

namespace lancret {
namespace {

void helix_advance(benchmark::State& run) {
    HelixState<float> state;
    const Vec3f u(0.3f, 0.2f, 0.5f);
    for (auto _ : run) {
        advance<float>(state, u, 0.1f);
        orthonormalize<float>(state.frame);
        benchmark::DoNotOptimize(state);
    }
    run.SetItemsProcessed(run.iterations());
}
BENCHMARK(helix_advance);

}  // namespace
}  // namespace lancret
