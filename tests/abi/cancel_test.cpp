// Hosts that cancel at any moment.

#include <gtest/gtest.h>
#include <oneapi/tbb/parallel_for.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "tests/abi/plugin.h"

namespace lancret {
namespace {

/// Once `stop` is set, cancels on the polling thread but not on the calling one, so that
/// calls begin and are cancelled at any point.
struct CancelledByPolling {
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<bool> stop{false};

    lancret_host host() {
        lancret_host out = make_host();
        out.user = this;
        out.cancelled = [](void* user) -> int {
            const auto& self = *static_cast<CancelledByPolling*>(user);
            return self.stop && std::this_thread::get_id() != self.caller;
        };
        return out;
    }
};

TEST(PluginCancel, OkMeansThatTheWorkWasDone) {
    CancelledByPolling watch;
    const lancret_host host = watch.host();
    const auto context = make_context(&host);
    const auto groom = opened(context.get(), kSmallGroom);
    watch.stop = true;
    int cancelled = 0;
    for (int i = 0; i < 500; ++i) {
        bool called = false;
        const lancret_status status = expand_with(
            groom.get(), 0, make_options(LANCRET_BSPLINE), [&](const lancret_curves&) {
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

/// Cancels in a callback, and waits until the polling thread must have noticed.
void cancel_and_wait(CancelledByPolling& watch) {
    watch.stop = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

TEST(PluginCancel, LoopsOfASinkAreNotCancelled) {
    CancelledByPolling watch;
    const lancret_host host = watch.host();
    const auto context = make_context(&host);
    const auto groom = opened(context.get(), kSmallGroom);
    std::atomic<unsigned> seen{0};
    EXPECT_EQ(expand_with(groom.get(), 0, make_options(LANCRET_BSPLINE),
                          [&](const lancret_curves& curves) {
                              cancel_and_wait(watch);
                              tbb::parallel_for(0u, curves.strands,
                                                [&](unsigned) { ++seen; });
                              return LANCRET_OK;
                          }),
              LANCRET_OK);
    EXPECT_EQ(seen, 3000u);
    // The sinks of head and text as well.
    watch.stop = false;
    struct Sinks {
        CancelledByPolling* watch;
        std::atomic<int> turns{0};
        static void text(void* user, const char*) {
            auto& self = *static_cast<Sinks*>(user);
            cancel_and_wait(*self.watch);
            tbb::parallel_for(0, 100, [&](int) { ++self.turns; });
        }
        static lancret_status mesh(void* user, const lancret_mesh*) {
            text(user, nullptr);
            return LANCRET_OK;
        }
    } sinks{&watch};
    EXPECT_EQ(lancret_groom_describe(groom.get(), Sinks::text, &sinks), LANCRET_OK);
    EXPECT_EQ(sinks.turns, 100);
    watch.stop = false;
    EXPECT_EQ(lancret_groom_get_head(groom.get(), 0, Sinks::mesh, &sinks), LANCRET_OK);
    EXPECT_EQ(sinks.turns, 200);
}

TEST(PluginCancel, TheStatusOfASinkIsReturned) {
    CancelledByPolling watch;
    const lancret_host host = watch.host();
    const auto context = make_context(&host);
    const auto groom = opened(context.get(), kSmallGroom);
    EXPECT_EQ(expand_with(groom.get(), 0, make_options(LANCRET_BSPLINE),
                          [&](const lancret_curves&) {
                              cancel_and_wait(watch);
                              return 42;
                          }),
              42);
}

TEST(PluginCancel, LoopsOfALogAreNotCancelled) {
    struct Logged : CancelledByPolling {
        std::atomic<int> turns{0}, lines{0};
    } watch;
    lancret_host host = watch.host();
    host.user = &watch;
    host.cancelled = [](void* user) -> int {
        const auto& self = *static_cast<Logged*>(user);
        return self.stop && std::this_thread::get_id() != self.caller;
    };
    host.log = [](void* user, int, const char*) {
        auto& self = *static_cast<Logged*>(user);
        cancel_and_wait(self);
        ++self.lines;
        tbb::parallel_for(0, 100, [&](int) { ++self.turns; });
    };
    const auto context = make_context(&host);
    EXPECT_EQ(open(context.get(), text_source(kSmallGroom)).status, LANCRET_CANCELLED);
    EXPECT_GT(watch.lines, 0);
    EXPECT_EQ(watch.turns, 100 * watch.lines);
}

}  // namespace
}  // namespace lancret
