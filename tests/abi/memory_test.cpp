// Calls in which each allocation fails in turn.

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <functional>
#include <new>

#include "tests/abi/plugin.h"

namespace {

/// Number of allocations until one fails; negative: none fails.
std::atomic<long> g_until_refused{-1};

}  // namespace

// Replaces the operators of the plugin too.
void* operator new(std::size_t bytes) {
    if (g_until_refused >= 0 && g_until_refused-- == 0) throw std::bad_alloc();
    if (void* out = std::malloc(bytes > 0 ? bytes : 1)) return out;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace lancret {
namespace {

const std::string kTinyGroom =
    "[guides]\ncount = 8\nmade.strands = 12\n[strands]\ncount = 20\nseed = 5\n";

/// Fails the first allocation of `call`, then the second, ..., up to `max` of them or
/// until `call` makes fewer. Each time it must return LANCRET_OUT_OF_MEMORY or succeed.
void refuse_everywhere(const char* what, long max,
                       const std::function<lancret_status()>& call) {
    long refused = 0;
    for (long n = 0; n < max; ++n) {
        lancret_status status = LANCRET_OK;
        g_until_refused = n;
        EXPECT_NO_THROW(status = call()) << what << ", allocation " << n;
        const bool reached = g_until_refused < 0;
        g_until_refused = -1;
        EXPECT_TRUE(status == LANCRET_OK || status == LANCRET_OUT_OF_MEMORY)
            << what << ", allocation " << n << ": " << status;
        refused += status == LANCRET_OUT_OF_MEMORY;
        if (!reached) break;
    }
    EXPECT_GT(refused, 0) << what;
}

TEST(PluginMemory, AnyFailedAllocationIsAStatus) {
    const lancret_host host = make_host(1);
    const auto context = make_context(&host);
    const auto groom = opened(context.get(), kTinyGroom);
    const lancret_groom* g = groom.get();
    const auto options = make_options(LANCRET_BSPLINE, 255);
    refuse_everywhere("chunk_open", 400, [&] {
        lancret_chunk* chunk = nullptr;
        const lancret_status out = lancret_chunk_open(g, 0, &options, &chunk);
        EXPECT_EQ(chunk != nullptr, out == LANCRET_OK);
        lancret_chunk_close(chunk);
        return out;
    });
    refuse_everywhere("expand", 400, [&] {
        return lancret_groom_expand_chunk(
            g, 0, &options,
            [](void*, const lancret_curves*) -> lancret_status { return LANCRET_OK; },
            nullptr);
    });
    refuse_everywhere("bound", 400, [&] {
        float box[6];
        return lancret_groom_get_chunk_box(g, 0, &options, LANCRET_TIGHT, box);
    });
    refuse_everywhere("check_chunk", 400, [&] {
        lancret_check check{};
        check.size = sizeof check;
        return lancret_groom_check_chunk(g, 0, &options, &check);
    });
    const lancret_source source = text_source(kTinyGroom);
    // Only its first allocation, and lancret_groom_describe and lancret_context_evaluate
    // not at all: the TOML and JSON libraries allocate in noexcept functions.
    refuse_everywhere("open", 1, [&] {
        // A new context shares nothing with the groom above.
        lancret_context* unshared = nullptr;
        if (lancret_context_create(LANCRET_ABI_VERSION, &host, &unshared) != LANCRET_OK) {
            return lancret_status(LANCRET_OUT_OF_MEMORY);
        }
        lancret_groom* out = nullptr;
        char error[64];
        const lancret_status status =
            lancret_groom_open(unshared, &source, &out, error, sizeof error);
        EXPECT_EQ(out != nullptr, status == LANCRET_OK);
        lancret_groom_close(out);
        lancret_context_destroy(unshared);
        return status;
    });
}

TEST(PluginMemory, HostMemoryIsReleasedAfterAnyFailure) {
    struct Lender {
        long until_refused = 0, lent = 0;
    } lender;
    lancret_host host = make_host(1);
    host.user = &lender;
    host.allocate = [](void* user, std::size_t bytes, std::size_t alignment) -> void* {
        auto& self = *static_cast<Lender*>(user);
        if (self.until_refused-- == 0) return nullptr;
        self.lent += long(bytes);
        return std::aligned_alloc(alignment, (bytes + 63) / 64 * 64);
    };
    host.release = [](void* user, void* memory, std::size_t bytes) {
        static_cast<Lender*>(user)->lent -= long(bytes);
        std::free(memory);
    };
    const auto context = make_context(&host);
    const auto groom = opened(context.get(), kTinyGroom);
    const auto options = make_options(LANCRET_HERMITE, 255);
    int refused = 0;
    for (lancret_status status = LANCRET_FAILED; status != LANCRET_OK; ++refused) {
        lender.until_refused = refused;
        status = expand_with(
            groom.get(), 0, options,
            [](const lancret_curves&) -> lancret_status { return LANCRET_OK; });
        ASSERT_TRUE(status == LANCRET_OK || status == LANCRET_OUT_OF_MEMORY) << status;
        ASSERT_EQ(lender.lent, 0);
    }
    // Each array of the eight attributes failed once, and those of counts and positions.
    EXPECT_GT(refused, 10);
}

}  // namespace
}  // namespace lancret
