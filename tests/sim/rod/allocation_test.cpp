// Counts calls of malloc: steps with warm buffers must not allocate.

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>

#include "tests/sim/rod/rod_runs.h"

namespace {
std::atomic<long> allocations{0};
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
extern "C" {
void* __libc_malloc(std::size_t size);
void* malloc(std::size_t size) {
    allocations.fetch_add(1, std::memory_order_relaxed);
    return __libc_malloc(size);
}
}

namespace lancret {
namespace {

TEST(RodStep, WarmStepAllocatesNothing) {
    for (const Integrator integrator :
         {Integrator::implicit_euler, Integrator::bdf2, Integrator::semi_implicit}) {
        RodRun run = curled_run(20, 5, integrator);
        run.root_at = [](double t) { return swinging_root(t); };
        run.forces.drag = 0.1;
        for (int i = 0; i < 5; ++i) run.step(0.01);
        const long before = allocations;
        for (int i = 0; i < 50; ++i) run.step(0.01);
        EXPECT_EQ(allocations - before, 0) << int(integrator);
    }
    const long before = allocations;
    const std::vector<int> room(1000);
    EXPECT_GT(allocations - before, 0) << room.size();
}

}  // namespace
}  // namespace lancret
#endif
