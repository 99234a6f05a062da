#pragma once
// The bandwidth at which this machine writes memory, as a reference for other figures of
// the same run.

#include <benchmark/benchmark.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <vector>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace lancret::bench {

/// Fills `size` floats (a multiple of 4, 16-byte aligned), bypassing the caches if the
/// processor can; otherwise as std::fill does.
inline void fill_floats(float* data, std::size_t size, float value) {
#ifdef __SSE2__
    const __m128 four = _mm_set1_ps(value);
    for (std::size_t i = 0; i < size; i += 4) _mm_stream_ps(data + i, four);
    _mm_sfence();
#else
    std::fill(data, data + size, value);
#endif
}

/// Runs `work` on `threads` threads, of which this is one.
template <class Work>
void on_threads(int threads, Work&& work) {
    tbb::task_arena(threads).execute(work);
}

/// Bytes per second, by the clock and by the process's CPU time divided by the threads.
/// If other programs use the machine, only the latter is comparable.
struct FillBandwidth {
    double by_clock = 0, by_cpu = 0;
};

/// The bandwidth of `threads` threads (1 to 64) over 256 MB of touched pages, the best of
/// five passes. Measured once per run and number of threads.
inline const FillBandwidth& fill_bandwidths(int threads) {
    static std::array<FillBandwidth, 65> measured{};
    FillBandwidth& best = measured.at(std::size_t(threads));
    if (best.by_clock > 0) return best;
    struct alignas(16) Four {
        float x[4];
    };
    std::vector<Four> memory(std::size_t(16) << 20);
    for (int pass = 0; pass < 5; ++pass) {
        const std::clock_t cpu_start = std::clock();
        const auto start = std::chrono::steady_clock::now();
        on_threads(threads, [&] {
            tbb::parallel_for(
                tbb::blocked_range<std::size_t>(0, memory.size(), std::size_t(1) << 16),
                [&](const auto& range) {
                    fill_floats(memory[range.begin()].x, 4 * range.size(), float(pass));
                });
        });
        const std::chrono::duration<double> seconds =
            std::chrono::steady_clock::now() - start;
        const double cpu = double(std::clock() - cpu_start) / CLOCKS_PER_SEC / threads;
        const double bytes = double(memory.size() * sizeof(Four));
        best.by_clock = std::max(best.by_clock, bytes / seconds.count());
        best.by_cpu = std::max(best.by_cpu, bytes / cpu);
        benchmark::DoNotOptimize(memory.data());
    }
    return best;
}

inline double fill_bandwidth(int threads) { return fill_bandwidths(threads).by_clock; }

}  // namespace lancret::bench
