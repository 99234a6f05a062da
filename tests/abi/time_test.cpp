#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "guides/guide_cache.h"
#include "procedural/generator.h"
#include "procedural/groom_source.h"
#include "procedural/moving_groom.h"
#include "tests/abi/plugin.h"

namespace lancret {
namespace {

/// A groom whose head moves and turns, and whose guides bend, from frame 3 to 6.
class PluginTime : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() /
                  ("lancret_abi_time_" + std::to_string(getpid()));
        std::filesystem::create_directory(folder_);
        std::ofstream(folder_ / "head.toml")
            << kSmallGroom << "[motion]\npivot = [0, -5, 0]\n"
            << "[[motion.keys]]\nframe = 3\n[[motion.keys]]\nframe = 6\n"
            << "move = [4, 1, -2]\nturn = [0, 40, 10]\n";
        GroomSource source;
        source.path = folder_ / "head.toml";
        const SourcedGroom groom = read_groom_source(source);
        const Generator generator = make_generator(groom.groom);
        const ScalpPoseAt pose = head_pose(groom.motion, groom.groom);
        std::vector<Guides> frames;
        for (int f = 3; f <= 6; ++f) {
            Guides guides = generator.source.guides;
            const auto head = std::get<RigidPose>(pose(f));
            for (std::size_t g = 0; g < guides.size(); ++g) {
                guides.root_positions[g] = head * guides.root_positions[g];
                guides.root_frames[g] = head.rotation * guides.root_frames[g];
            }
            for (Vec3& k : guides.curvatures) k.y() += 0.02 * (f - 3);
            frames.push_back(std::move(guides));
        }
        cache_ = (folder_ / "head.h5").string();
        GuideCacheWriter writer(cache_, {24, 3, (folder_ / "head.toml").string()}, 4,
                                &generator.source.guides);
        for (const Guides& frame : frames) writer.add(frame);
        writer.finish();
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    GroomHandle open_cache(lancret_context* context, lancret_u32 chunk = 0) {
        lancret_source source{};
        source.size = sizeof source;
        source.path = cache_.c_str();
        source.chunk_strands = chunk;
        Opened out = open(context, source);
        EXPECT_EQ(out.status, LANCRET_OK) << out.error;
        return std::move(out.groom);
    }

    std::filesystem::path folder_;
    std::string cache_;
};

TEST_F(PluginTime, StrandsAreThoseOfTheLibraryAtAndBetweenFrames) {
    const auto context = a_context();
    const auto groom = open_cache(context.get(), 800);
    const lancret_info info = info_of(groom.get());
    EXPECT_EQ(info.first_frame, 3);
    EXPECT_EQ(info.last_frame, 6);
    GroomSource source;
    source.path = cache_;
    const SourcedGroom sourced = read_groom_source(source);
    Generator generator = make_generator(sourced.groom);
    const GroomTimes times =
        groom_times(sourced.groom, head_pose(sourced.motion, sourced.groom));
    const RestPlaces rest = prepare_frames(generator, times);
    // Twice the same, and one beyond the end, which is held.
    const std::vector<double> asked = {3, 4.25, 6, 4.25, 100};
    auto options = some_options(LANCRET_BSPLINE);
    options.times = asked.data();
    options.time_count = asked.size();
    for (std::size_t t = 0; t < asked.size(); ++t) {
        const FrameState state =
            go_to_frame(generator, rest, times, std::min(asked[t], 6.0));
        const Curves curves =
            expand(generator.binding, state.classed, generator.groom.expand);
        const auto strands = expanded(groom.get(), options, false, t);
        ASSERT_EQ(strands.size(), curves.strands);
        std::map<std::uint32_t, std::uint32_t> places;
        for (std::uint32_t i = 0; i < curves.strands; ++i) places[curves.id_of(i)] = i;
        for (const auto& [id, strand] : strands) {
            const std::uint32_t place = places.at(id), m = curves.points_of(place);
            ASSERT_EQ(strand.positions.size(), 4 * std::size_t(m));
            ASSERT_EQ(std::memcmp(strand.positions.data(),
                                  curves.points.data() + curves.first_point(place),
                                  m * sizeof(Point4f)),
                      0)
                << asked[t];
        }
    }
}

TEST_F(PluginTime, WhatMovesIsNotStill) {
    const auto context = a_context();
    const auto groom = open_cache(context.get());
    const auto still = [&](std::vector<double> times) {
        int out = -1;
        EXPECT_EQ(lancret_is_still(groom.get(), times.data(), times.size(), &out),
                  LANCRET_OK);
        return out;
    };
    EXPECT_EQ(still({3, 4}), 0);
    EXPECT_EQ(still({3, 3, 5.5}), 0);
    EXPECT_EQ(still({4.5, 4.5}), 1);
    EXPECT_EQ(still({6, 100}), 1);  // held beyond the end
    EXPECT_EQ(info_of(groom.get()).frames, 4);
}

TEST_F(PluginTime, BoundsHoldAllTimesAndBetween) {
    const auto context = a_context();
    const auto groom = open_cache(context.get(), 800);
    const std::vector<double> asked = {3.5, 4, 5.5};
    auto options = some_options(LANCRET_HERMITE);
    options.times = asked.data();
    options.time_count = asked.size();
    for (const int kind : {LANCRET_REACH, LANCRET_TIGHT}) {
        for (lancret_u32 chunk = 0; chunk < info_of(groom.get()).chunks; ++chunk) {
            float box[6];
            ASSERT_EQ(lancret_bound(groom.get(), chunk, &options, kind, box), LANCRET_OK);
            std::size_t outside = 0;
            const auto look = [&](const lancret_curves& c) {
                EXPECT_EQ(c.times, 3u);
                for (std::size_t t = 0; t < 3; ++t) {
                    for (std::size_t p = 0; p < c.points; ++p) {
                        const float* at = c.positions[t] + 4 * p;
                        for (int a = 0; a < 3; ++a) {
                            outside +=
                                !(at[a] - at[3] >= box[a] && at[a] + at[3] <= box[3 + a]);
                        }
                    }
                }
                return LANCRET_OK;
            };
            ASSERT_EQ(expand_with(groom.get(), chunk, options, look), LANCRET_OK);
            EXPECT_EQ(outside, 0u);
        }
    }
}

TEST_F(PluginTime, BuffersGetWhatASinkGets) {
    const auto context = a_context();
    const auto groom = open_cache(context.get());
    const std::vector<double> asked = {3, 5.5};
    auto options = some_options(LANCRET_CATMULL_ROM);
    options.times = asked.data();
    options.time_count = 2;
    lancret_chunk* chunk = nullptr;
    ASSERT_EQ(lancret_chunk_open(groom.get(), 0, &options, &chunk), LANCRET_OK);
    lancret_curves curves{};
    curves.size = sizeof curves;
    ASSERT_EQ(lancret_chunk_sizes(chunk, &curves), LANCRET_OK);
    std::vector<Point4f> first(curves.points), second(curves.points);
    const float* positions[] = {&first[0].x, &second[0].x};
    std::vector<lancret_u32> ids(curves.strands);
    curves.positions = positions;
    curves.ids = ids.data();
    ASSERT_EQ(lancret_chunk_write(chunk, &curves), LANCRET_OK);
    lancret_chunk_close(chunk);
    const auto look = [&](const lancret_curves& c) {
        const std::size_t bytes = curves.points * sizeof(Point4f);
        EXPECT_EQ(std::memcmp(c.positions[0], first.data(), bytes), 0);
        EXPECT_EQ(std::memcmp(c.positions[1], second.data(), bytes), 0);
        EXPECT_NE(std::memcmp(c.positions[0], second.data(), bytes), 0);
        return LANCRET_OK;
    };
    EXPECT_EQ(expand_with(groom.get(), 0, options, look), LANCRET_OK);
    EXPECT_EQ(std::ranges::max(ids), 2999u);
}

TEST_F(PluginTime, AFileThatChangesIsLoadedAgain) {
    const auto context = a_context();
    const std::string path = (folder_ / "head.toml").string();
    lancret_source source{};
    source.size = sizeof source;
    source.path = path.c_str();
    const Opened before = open(context.get(), source);
    std::ofstream(path, std::ios::app) << "# longer\n[width]\nroot = 0.02\n";
    const Opened after = open(context.get(), source);
    const auto radius = [&](const Opened& groom) {
        return expanded(groom.groom.get(), some_options(LANCRET_LINEAR))
            .at(0)
            .positions[3];
    };
    EXPECT_EQ(radius(after), 0.01f);
    EXPECT_NE(radius(before), 0.01f);
}

TEST_F(PluginTime, ACacheThatChangesUnderAnOpenGroomIsAnError) {
    std::string line;
    lancret_host host = a_host(1);  // whose log comes from one thread
    host.user = &line;
    host.log = [](void* user, int level, const char* text) {
        if (level == LANCRET_LOG_ERROR) *static_cast<std::string*>(user) = text;
    };
    const auto context = a_context(&host);
    const auto groom = open_cache(context.get());
    const double times[] = {4};
    auto options = some_options(LANCRET_BSPLINE);
    options.times = times;
    options.time_count = 1;
    const auto ignore = [](const lancret_curves&) { return LANCRET_OK; };
    // As another run leaves it: as many frames and guides, written later.
    std::filesystem::copy_file(cache_, folder_ / "new.h5");
    std::filesystem::last_write_time(
        folder_ / "new.h5",
        std::filesystem::last_write_time(cache_) + std::chrono::seconds(1));
    std::filesystem::rename(folder_ / "new.h5", cache_);
    EXPECT_EQ(expand_with(groom.get(), 0, options, ignore), LANCRET_BAD_INPUT);
    EXPECT_EQ(line, cache_ + ": has changed since it was opened");
    options.max_error = 0.02f;
    EXPECT_EQ(expand_with(groom.get(), 0, options, ignore), LANCRET_BAD_INPUT);
    // Opened again it is another groom.
    const auto again = open_cache(context.get());
    EXPECT_EQ(expand_with(again.get(), 0, options, ignore), LANCRET_OK);
}

TEST_F(PluginTime, AFileThatKeepsSizeAndTimeIsReadAgain) {
    const auto context = a_context();
    const std::string path = (folder_ / "own.toml").string();
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

TEST_F(PluginTime, ACacheTakesNoStrandsOfTheHosts) {
    const auto context = a_context();
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
    EXPECT_NE(out.error.find("has guides of its own"), std::string::npos) << out.error;
}

}  // namespace
}  // namespace lancret
