// Hosts that cancel at the worst moments.

#include <gtest/gtest.h>
#include <oneapi/tbb/parallel_for.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "tests/abi/plugin.h"

namespace lancret {
namespace {

/// Says no to the thread that calls and, from when it is told to, yes to the one that
/// watches: calls begin, and are cancelled at any place of them.
struct CancelledByTheWatch {
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<bool> stop{false};

    lancret_host host() {
        lancret_host out = a_host();
        out.user = this;
        out.cancelled = [](void* user) -> int {
            const auto& own = *static_cast<CancelledByTheWatch*>(user);
            return own.stop && std::this_thread::get_id() != own.caller;
        };
        return out;
    }
};

TEST(PluginCancel, OkMeansThatItWasDone) {
    CancelledByTheWatch watch;
    const lancret_host host = watch.host();
    const auto context = a_context(&host);
    const auto groom = opened(context.get(), kSmallGroom);
    watch.stop = true;
    int cancelled = 0;
    for (int i = 0; i < 500; ++i) {
        bool called = false;
        const lancret_status status = expand_with(
            groom.get(), 0, some_options(LANCRET_BSPLINE), [&](const lancret_curves&) {
                called = true;
                return LANCRET_OK;
            });
        ASSERT_TRUE(status == LANCRET_CANCELLED || status == LANCRET_OK);
        ASSERT_EQ(called, status == LANCRET_OK);
        cancelled += status == LANCRET_CANCELLED;
        lancret_groom_info info{};
        info.size = sizeof info;
        const lancret_status informed = lancret_groom_get_info(groom.get(), &info);
        ASSERT_TRUE(informed == LANCRET_CANCELLED || informed == LANCRET_OK);
        ASSERT_EQ(info.chunks > 0, informed == LANCRET_OK);
    }
    EXPECT_GT(cancelled, 0);
    for (int i = 0; i < 50; ++i) {
        const std::string text = kSmallGroom + "density = 0." + std::to_string(i + 1);
        const Opened out = open(context.get(), text_source(text));
        ASSERT_TRUE(out.status == LANCRET_CANCELLED || out.status == LANCRET_OK)
            << out.error;
        ASSERT_EQ(out.groom != nullptr, out.status == LANCRET_OK);
    }
}

/// Cancels in a sink, and waits until that is sure to have been seen.
void cancel_and_wait(CancelledByTheWatch& watch) {
    watch.stop = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

TEST(PluginCancel, ASinksOwnLoopsAreNotCut) {
    CancelledByTheWatch watch;
    const lancret_host host = watch.host();
    const auto context = a_context(&host);
    const auto groom = opened(context.get(), kSmallGroom);
    std::atomic<unsigned> seen{0};
    EXPECT_EQ(expand_with(groom.get(), 0, some_options(LANCRET_BSPLINE),
                          [&](const lancret_curves& curves) {
                              cancel_and_wait(watch);
                              tbb::parallel_for(0u, curves.strands,
                                                [&](unsigned) { ++seen; });
                              return LANCRET_OK;
                          }),
              LANCRET_OK);
    EXPECT_EQ(seen, 3000u);
    // The head, the text and the log are handed over likewise.
    watch.stop = false;
    struct Told {
        CancelledByTheWatch* watch;
        std::atomic<int> turns{0};
        static void text(void* user, const char*) {
            auto& own = *static_cast<Told*>(user);
            cancel_and_wait(*own.watch);
            tbb::parallel_for(0, 100, [&](int) { ++own.turns; });
        }
        static lancret_status mesh(void* user, const lancret_mesh*) {
            text(user, nullptr);
            return LANCRET_OK;
        }
    } told{&watch};
    EXPECT_EQ(lancret_groom_describe(groom.get(), Told::text, &told), LANCRET_OK);
    EXPECT_EQ(told.turns, 100);
    watch.stop = false;
    EXPECT_EQ(lancret_groom_get_head(groom.get(), 0, Told::mesh, &told), LANCRET_OK);
    EXPECT_EQ(told.turns, 200);
}

TEST(PluginCancel, ASinksOwnStatusIsKept) {
    CancelledByTheWatch watch;
    const lancret_host host = watch.host();
    const auto context = a_context(&host);
    const auto groom = opened(context.get(), kSmallGroom);
    EXPECT_EQ(expand_with(groom.get(), 0, some_options(LANCRET_BSPLINE),
                          [&](const lancret_curves&) {
                              cancel_and_wait(watch);
                              return 42;
                          }),
              42);
}

TEST(PluginCancel, ALogsOwnLoopsAreNotCut) {
    struct Logged : CancelledByTheWatch {
        std::atomic<int> turns{0}, lines{0};
    } watch;
    lancret_host host = watch.host();
    host.user = &watch;
    host.cancelled = [](void* user) -> int {
        const auto& own = *static_cast<Logged*>(user);
        return own.stop && std::this_thread::get_id() != own.caller;
    };
    host.log = [](void* user, int, const char*) {
        auto& own = *static_cast<Logged*>(user);
        cancel_and_wait(own);
        ++own.lines;
        tbb::parallel_for(0, 100, [&](int) { ++own.turns; });
    };
    const auto context = a_context(&host);
    EXPECT_EQ(open(context.get(), text_source(kSmallGroom)).status, LANCRET_CANCELLED);
    EXPECT_GT(watch.lines, 0);
    EXPECT_EQ(watch.turns, 100 * watch.lines);
}

}  // namespace
}  // namespace lancret
