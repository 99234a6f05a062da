#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <mutex>
#include <set>
#include <thread>

#include "tests/abi/plugin.h"

namespace lancret {
namespace {

/// A host that counts the calls of its callbacks.
struct CountingHost {
    std::atomic<long> lent{0};   ///< bytes
    std::atomic<long> polls{0};  ///< calls of `cancelled`
    std::atomic<bool> stop{false}, full{false};
    std::mutex mutex;
    std::vector<std::string> lines;
    std::string stop_at;  ///< line of the log that sets `stop`

    lancret_host host() {
        lancret_host out = make_host();
        out.user = this;
        out.log = [](void* user, int, const char* text) {
            auto& self = *static_cast<CountingHost*>(user);
            const std::lock_guard lock(self.mutex);
            self.lines.emplace_back(text);
            if (self.lines.back() == self.stop_at) self.stop = true;
        };
        out.allocate = [](void* user, std::size_t bytes, std::size_t alignment) -> void* {
            auto& self = *static_cast<CountingHost*>(user);
            if (self.full) return nullptr;
            self.lent += long(bytes);
            return std::aligned_alloc(alignment, (bytes + 63) / 64 * 64);
        };
        out.release = [](void* user, void* memory, std::size_t bytes) {
            static_cast<CountingHost*>(user)->lent -= long(bytes);
            std::free(memory);
        };
        out.cancelled = [](void* user) -> int {
            auto& self = *static_cast<CountingHost*>(user);
            ++self.polls;
            return self.stop;
        };
        return out;
    }
};

TEST(PluginHost, ArraysOfASinkAreInTheHostsMemory) {
    CountingHost counting;
    const lancret_host host = counting.host();
    const auto context = make_context(&host);
    const auto groom = opened(context.get(), kSmallGroom);
    lancret_u32 points = 0;
    const auto options = make_options(LANCRET_BSPLINE);
    const auto look = [&](const lancret_curves& curves) {
        points = curves.points;
        EXPECT_GE(counting.lent, long(points) * 16);
        return LANCRET_OK;
    };
    EXPECT_EQ(expand_with(groom.get(), 0, options, look), LANCRET_OK);
    EXPECT_GT(points, 0u);
    EXPECT_EQ(counting.lent, 0);
    counting.full = true;
    EXPECT_EQ(expand_with(groom.get(), 0, options, look), LANCRET_OUT_OF_MEMORY);
    counting.full = false;
    EXPECT_EQ(expand_with(groom.get(), 0, options, look), LANCRET_OK);
    EXPECT_EQ(counting.lent, 0);
}

TEST(PluginHost, HalfAnAllocatorIsRefused) {
    lancret_host host = CountingHost().host();
    host.release = nullptr;
    lancret_context* context = nullptr;
    EXPECT_EQ(lancret_context_create(LANCRET_ABI_VERSION, &host, &context),
              LANCRET_BAD_CALL);
    EXPECT_EQ(context, nullptr);
}

TEST(PluginHost, WarningsGoToTheLog) {
    CountingHost counting;
    const lancret_host host = counting.host();
    const auto context = make_context(&host);
    const auto groom =
        opened(context.get(), kSmallGroom +
                                  "[[partings]]\npoints = [[0, 90, 0], [0, "
                                  "90, 5]]\n");
    const std::lock_guard lock(counting.mutex);
    EXPECT_TRUE(std::ranges::any_of(counting.lines, [](const std::string& line) {
        return line.find("[[partings]] are up to") != std::string::npos;
    }));
}

TEST(PluginHost, CancelsBeforeAndInTheMiddle) {
    CountingHost counting;
    const lancret_host host = counting.host();
    const auto context = make_context(&host);
    counting.stop = true;
    const std::string large =
        "[guides]\ncount = 2000\nmade.strands = 4000\n[strands]\ncount = 400000\n";
    EXPECT_EQ(open(context.get(), text_source(large)).status, LANCRET_CANCELLED);
    counting.stop = false;
    // While opening: as the fit begins, which takes many times as long as the interval at
    // which the host is polled.
    counting.stop_at = "groom: fit";
    const auto out = open(context.get(), text_source(large));
    counting.stop_at.clear();
    EXPECT_TRUE(counting.stop);
    EXPECT_EQ(out.status, LANCRET_CANCELLED);
    EXPECT_EQ(out.error, "cancelled");
    EXPECT_GT(counting.polls, 2);
    // What was cancelled can be requested again.
    counting.stop = false;
    const auto groom = opened(context.get(), kSmallGroom);
    counting.stop = true;
    EXPECT_EQ(expand_with(groom.get(), 0, make_options(LANCRET_BEZIER),
                          [](const lancret_curves&) { return LANCRET_OK; }),
              LANCRET_CANCELLED);
    counting.stop = false;
    EXPECT_EQ(expanded(groom.get(), make_options(LANCRET_BEZIER)).size(), 3000u);
}

TEST(PluginHost, ThreadLimitHolds) {
    for (const int limit : {1, 2}) {
        const lancret_host host = make_host(limit);
        const auto context = make_context(&host);
        const auto groom = opened(context.get(), kSmallGroom);
        EXPECT_EQ(expanded(groom.get(), make_options(LANCRET_BSPLINE)).size(), 3000u);
    }
    // With one thread the calling thread does everything, and the sink is called on it.
    const lancret_host host = make_host(1);
    const auto context = make_context(&host);
    const auto groom = opened(context.get(), kSmallGroom);
    std::thread::id sink;
    expand_with(groom.get(), 0, make_options(LANCRET_BSPLINE),
                [&](const lancret_curves&) {
                    sink = std::this_thread::get_id();
                    return LANCRET_OK;
                });
    EXPECT_EQ(sink, std::this_thread::get_id());
}

TEST(PluginHost, GroomsOfOneSourceShareWhatWasLoaded) {
    const auto context = make_context();
    const auto first = opened(context.get(), kSmallGroom);
    const auto second = opened(context.get(), kSmallGroom);
    const auto other = opened(context.get(), kSmallGroom + "density = 0.5\n");
    const auto guides = [](const GroomHandle& groom) {
        lancret_guides out{};
        out.size = sizeof out;
        EXPECT_EQ(lancret_groom_get_guides(groom.get(), &out), LANCRET_OK);
        return out.curvatures;
    };
    EXPECT_EQ(guides(first), guides(second));
    EXPECT_NE(guides(first), guides(other));
    EXPECT_EQ(info_of(second.get()).fit_seconds, info_of(first.get()).fit_seconds);
    // Contexts share nothing.
    const auto other_context = make_context();
    EXPECT_NE(guides(first), guides(opened(other_context.get(), kSmallGroom)));
}

TEST(PluginHost, EightThreadsOpenExpandCloseAndCancel) {
    CountingHost counting;
    lancret_host host = counting.host();
    const auto context = make_context(&host);
    const auto reference = expanded(opened(context.get(), kSmallGroom, 500).get(),
                                    make_options(LANCRET_BSPLINE));
    std::atomic<int> done{0}, cancelled{0};
    const auto work = [&](int number) {
        for (int round = 0; round < 6; ++round) {
            lancret_source source = text_source(kSmallGroom);
            source.chunk_strands = 500;
            const Opened groom = open(context.get(), source);
            if (groom.status == LANCRET_CANCELLED) {
                ++cancelled;
                continue;
            }
            ASSERT_EQ(groom.status, LANCRET_OK) << groom.error;
            const auto options =
                make_options(number % 2 ? LANCRET_BSPLINE : LANCRET_LINEAR, LANCRET_IDS);
            AllStrands strands;
            const lancret_u32 chunk = lancret_u32(number + round) % 6;
            const lancret_status status = expand_with(groom.groom.get(), chunk, options,
                                                      [&](const lancret_curves& c) {
                                                          collect(c, 0, strands);
                                                          return LANCRET_OK;
                                                      });
            if (status == LANCRET_CANCELLED) {
                ++cancelled;
                continue;
            }
            ASSERT_EQ(status, LANCRET_OK);
            ASSERT_EQ(strands.size(), 500u);
            ++done;
            if (number % 2 == 0) continue;
            for (const auto& [id, strand] : strands) {
                ASSERT_TRUE(strand.positions == reference.at(id).positions);
            }
        }
    };
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i) threads.emplace_back(work, i);
    std::thread cancel([&] {
        for (int i = 0; i < 5; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(15));
            counting.stop = true;
            std::this_thread::sleep_for(std::chrono::milliseconds(4));
            counting.stop = false;
        }
    });
    for (std::thread& thread : threads) thread.join();
    cancel.join();
    EXPECT_EQ(done + cancelled, 48);
    EXPECT_EQ(counting.lent, 0);
    EXPECT_EQ(expanded(opened(context.get(), kSmallGroom, 500).get(),
                       make_options(LANCRET_BSPLINE)),
              reference);
}

}  // namespace
}  // namespace lancret
