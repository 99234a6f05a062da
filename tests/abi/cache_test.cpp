// Files that change, and what is cached of them.

#include <gtest/gtest.h>

#include <chrono>
#include <cstring>

#include "tests/abi/moving_plugin.h"

namespace lancret {
namespace {

using PluginCache = MovingPlugin;

TEST_F(PluginCache, AFileThatChangesIsLoadedAgain) {
    const auto context = make_context();
    const std::string path = (folder_ / "head.toml").string();
    lancret_source source{};
    source.size = sizeof source;
    source.path = path.c_str();
    const Opened before = open(context.get(), source);
    std::ofstream(path, std::ios::app) << "# longer\n[width]\nroot = 0.02\n";
    const Opened after = open(context.get(), source);
    const auto radius = [&](const Opened& groom) {
        return expanded(groom.groom.get(), make_options(LANCRET_LINEAR))
            .at(0)
            .positions[3];
    };
    EXPECT_EQ(radius(after), 0.01f);
    EXPECT_NE(radius(before), 0.01f);
}

TEST_F(PluginCache, ACacheThatChangesUnderAnOpenGroomIsAnError) {
    std::string line;
    lancret_host host = make_host(1);  // logs from one thread
    host.user = &line;
    host.log = [](void* user, int level, const char* text) {
        if (level == LANCRET_LOG_ERROR) *static_cast<std::string*>(user) = text;
    };
    const auto context = make_context(&host);
    const auto groom = open_cache(context.get());
    const double times[] = {4};
    auto options = make_options(LANCRET_BSPLINE);
    options.times = times;
    options.time_count = 1;
    const auto ignore = [](const lancret_curves&) { return LANCRET_OK; };
    // As rewritten by another run: the same number of frames and guides, but later.
    std::filesystem::copy_file(cache_, folder_ / "new.h5");
    std::filesystem::last_write_time(
        folder_ / "new.h5",
        std::filesystem::last_write_time(cache_) + std::chrono::seconds(1));
    std::filesystem::rename(folder_ / "new.h5", cache_);
    EXPECT_EQ(expand_with(groom.get(), 0, options, ignore), LANCRET_BAD_INPUT);
    EXPECT_EQ(line, cache_ + ": has changed since it was opened");
    options.max_error = 0.02f;
    EXPECT_EQ(expand_with(groom.get(), 0, options, ignore), LANCRET_BAD_INPUT);
    // Opened again, it is another groom.
    const auto again = open_cache(context.get());
    EXPECT_EQ(expand_with(again.get(), 0, options, ignore), LANCRET_OK);
}

TEST_F(PluginCache, AFileThatKeepsSizeAndTimeIsReadAgain) {
    const auto context = make_context();
    const std::string path = (folder_ / "groom.toml").string();
    lancret_source source{};
    source.size = sizeof source;
    source.path = path.c_str();
    const auto write = [&](const char* count) {
        std::ofstream(path) << "[guides]\nmade.strands = 20\n[strands]\ncount = " << count
                            << "\n";
    };
    write("100");
    const auto time = std::filesystem::last_write_time(path);
    const Opened before = open(context.get(), source);
    write("200");
    std::filesystem::last_write_time(path, time);
    const Opened after = open(context.get(), source);
    EXPECT_EQ(info_of(before.groom.get()).strands, 100u);
    EXPECT_EQ(info_of(after.groom.get()).strands, 200u);
}

TEST_F(PluginCache, ACacheRejectsStrandsOfTheHost) {
    const auto context = make_context();
    const float points[] = {0, 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0};
    const lancret_u32 counts[] = {4};
    const lancret_strands strands{sizeof(lancret_strands), LANCRET_LINEAR, 1, counts,
                                  points};
    lancret_source source{};
    source.size = sizeof source;
    source.path = cache_.c_str();
    source.strands = &strands;
    const Opened out = open(context.get(), source);
    EXPECT_EQ(out.status, LANCRET_BAD_INPUT);
    EXPECT_NE(out.error.find("contains its own guides"), std::string::npos) << out.error;
}

TEST_F(PluginCache, GuidesOfAllTimesOfACallAreKept) {
    const auto context = make_context();
    const auto groom = open_cache(context.get(), 800);
    std::vector<double> times;
    for (int i = 0; i < 40; ++i) times.push_back(3 + 0.05 * i);
    auto options = make_options(LANCRET_BSPLINE);
    options.times = times.data();
    options.time_count = times.size();
    const auto ignore = [](const lancret_curves&) { return LANCRET_OK; };
    ASSERT_EQ(expand_with(groom.get(), 0, options, ignore), LANCRET_OK);
    // Reading the cache again would fail.
    std::filesystem::remove(cache_);
    for (const lancret_u32 chunk : {1, 2, 0}) {
        EXPECT_EQ(expand_with(groom.get(), chunk, options, ignore), LANCRET_OK);
    }
}

TEST_F(PluginCache, AChunkOutlivesItsGroom) {
    const auto context = make_context();
    auto groom = open_cache(context.get());
    const double times[] = {3.5};
    auto options = make_options(LANCRET_BSPLINE);
    options.times = times;
    options.time_count = 1;
    std::vector<float> expected;
    const auto keep = [&](const lancret_curves& c) {
        expected.assign(c.positions[0], c.positions[0] + 4 * std::size_t(c.points));
        return LANCRET_OK;
    };
    ASSERT_EQ(expand_with(groom.get(), 0, options, keep), LANCRET_OK);
    lancret_chunk* chunk = nullptr;
    ASSERT_EQ(lancret_chunk_open(groom.get(), 0, &options, &chunk), LANCRET_OK);
    groom.reset();
    lancret_curves curves{};
    curves.size = sizeof curves;
    ASSERT_EQ(lancret_chunk_get_sizes(chunk, &curves), LANCRET_OK);
    ASSERT_EQ(4 * std::size_t(curves.points), expected.size());
    std::vector<Point4f> points(curves.points);
    const float* positions[] = {&points[0].x};
    curves.positions = positions;
    EXPECT_EQ(lancret_chunk_write(chunk, &curves), LANCRET_OK);
    EXPECT_EQ(std::memcmp(points.data(), expected.data(), 4 * expected.size()), 0);
    lancret_chunk_close(chunk);
}

}  // namespace
}  // namespace lancret
