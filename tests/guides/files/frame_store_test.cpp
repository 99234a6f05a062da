#include "guides/files/frame_store.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

#include "tests/guides/base/temporary_folder.h"

namespace lancret {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr int kFrames = 6;

/// Three guides of two segments that bend over time.
Guides guides_at(int k) {
    Guides out;
    out.segments = 2;
    for (int g = 0; g < 3; ++g) {
        out.root_positions.emplace_back(g, 0.1 * k, 0);
        const Vec3 axis = Vec3(1, g, 2).normalized();
        out.root_frames.push_back(Eigen::AngleAxisd(0.1 * k, axis).toRotationMatrix());
        for (int s = 0; s < 2; ++s) {
            out.segment_lengths.push_back(1 + 0.25 * g + s);
            out.curvatures.emplace_back(0.1 * s, 0.01 * k, std::sin(0.3 * k + g));
        }
    }
    return out;
}

RestartArrays arrays_at(int k) {
    return {{"rates", {0.5 * k, -1.0 / (k + 1)}}, {"anchors", {}}, {"step", {1e-3}}};
}

struct StoredFrames : testing::Test {
    TemporaryFolder folder;
    std::filesystem::path path = folder / "cache.h5";
    std::filesystem::path frames = folder / "cache.h5.frames";

    FrameStore store(const std::string& job = "job", bool restart = false) const {
        return {path, {24, 41, "a.toml"}, job, guides_at(0), restart};
    }
    /// Continues a run up to `count` frames.
    static void run(FrameStore& store, int count) {
        while (store.frames_done() < count) {
            const int k = store.frames_done() + 1;
            store.add(guides_at(k), arrays_at(k));
        }
    }
    /// The cache of an uninterrupted run.
    std::string whole_run(int count = kFrames) const {
        const TemporaryFolder other;
        FrameStore s(other / "cache.h5", {24, 41, "a.toml"}, "job", guides_at(0));
        run(s, count);
        s.finish();
        return read_bytes(other / "cache.h5");
    }
};

TEST_F(StoredFrames, FinishesToACacheOfAllFrames) {
    FrameStore s = store();
    EXPECT_EQ(s.frames_done(), 0);
    EXPECT_THROW(s.last(), std::logic_error);
    EXPECT_THROW(s.finish(), std::logic_error);
    run(s, kFrames);
    EXPECT_FALSE(std::filesystem::exists(path));
    s.finish();
    EXPECT_FALSE(std::filesystem::exists(frames));
    const GuideCacheInfo info = guide_cache_info(path);
    EXPECT_EQ(info.frames, kFrames);
    EXPECT_EQ(info.first_frame, 41);
    EXPECT_EQ(info.groom, "a.toml");
    for (int k = 0; k < kFrames; ++k) {
        const Guides back = read_guide_cache(path, k);
        EXPECT_EQ(back.curvatures, guides_at(k + 1).curvatures);
        EXPECT_EQ(back.root_frames, guides_at(k + 1).root_frames);
    }
    const Guides rest = read_rest_guides(path);
    EXPECT_EQ(rest.curvatures, guides_at(0).curvatures);
    EXPECT_EQ(rest.root_positions, guides_at(0).root_positions);
    EXPECT_EQ(rest.segment_lengths, guides_at(0).segment_lengths);
}

TEST_F(StoredFrames, EachFrameIsACache) {
    FrameStore s = store();
    run(s, 2);
    const auto file = frames / "000042.h5";
    EXPECT_EQ(s.frame_file(1), file);
    const GuideCacheInfo info = guide_cache_info(file);
    EXPECT_EQ(info.frames, 1);
    EXPECT_EQ(info.first_frame, 42);
    EXPECT_TRUE(info.has_rest);
    EXPECT_EQ(read_guide_cache(file, 0).curvatures, guides_at(2).curvatures);
    const Restart restart = read_restart(file);
    EXPECT_EQ(restart.job, "job");
    EXPECT_EQ(restart.arrays, arrays_at(2));
}

TEST_F(StoredFrames, AContinuedRunGivesTheSameBytes) {
    const std::string whole = whole_run();
    // A second later, so that a time stamp would differ.
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    for (const int part : {1, 3, 5}) {
        {
            FrameStore s = store();
            EXPECT_EQ(s.frames_done(), part == 1 ? 0 : part == 3 ? 1 : 3);
            run(s, part);
        }
        const LastFrame last = store().last();
        EXPECT_EQ(last.number, 40 + part);
        EXPECT_EQ(last.guides.curvatures, guides_at(part).curvatures);
        EXPECT_EQ(last.arrays, arrays_at(part));
    }
    FrameStore s = store();
    run(s, kFrames);
    s.finish();
    EXPECT_EQ(read_bytes(path), whole);
}

TEST_F(StoredFrames, ALongerRunContinuesFromAFinishedCache) {
    FrameStore first = store();
    run(first, 4);
    first.finish();
    const std::string four = read_bytes(path);
    FrameStore again = store();
    EXPECT_EQ(again.frames_done(), 4);
    EXPECT_EQ(again.last().arrays, arrays_at(4));
    again.finish();  // without new frames
    EXPECT_EQ(read_bytes(path), four);
    run(again, kFrames);
    again.finish();
    EXPECT_EQ(read_bytes(path), whole_run());
    EXPECT_EQ(folder.files(), 1u);
}

TEST_F(StoredFrames, ADamagedFrameAndAllAfterItCountAsNotDone) {
    FrameStore first = store();
    run(first, kFrames);
    const std::string good = read_bytes(frames / "000043.h5");
    // Truncated, emptied, with one byte of the guides changed, and with another number.
    std::string bent = good;
    const double number = guides_at(3).curvatures[1].z();
    const std::size_t at =
        good.find(std::string(reinterpret_cast<const char*>(&number), sizeof number));
    ASSERT_NE(at, std::string::npos);
    bent[at] = char(bent[at] ^ 1);
    for (const std::string& bytes : {good.substr(0, good.size() / 2), std::string(), bent,
                                     read_bytes(frames / "000042.h5")}) {
        {
            FrameStore s = store();
            run(s, kFrames);
        }
        write_bytes(frames / "000043.h5", bytes);
        FrameStore s = store();
        EXPECT_EQ(s.frames_done(), 2);
        EXPECT_FALSE(std::filesystem::exists(frames / "000044.h5"));
        EXPECT_EQ(s.last().number, 42);
    }
    FrameStore s = store();
    run(s, kFrames);
    s.finish();
    EXPECT_EQ(read_bytes(path), whole_run());
}

TEST_F(StoredFrames, FramesOfAnotherRunAreRejectedWithoutRestart) {
    FrameStore first = store();
    run(first, 3);
    EXPECT_THAT(
        input_error([&] { store("other"); }),
        AllOf(HasSubstr("000041.h5: is a frame of another run"), HasSubstr("--restart")));
    std::filesystem::remove(frames / "000041.h5");
    EXPECT_THAT(input_error([&] { store("other"); }), HasSubstr("000042.h5"));
    FrameStore s = store("other", true);
    EXPECT_EQ(s.frames_done(), 0);
    EXPECT_TRUE(std::filesystem::is_empty(frames));
}

TEST_F(StoredFrames, AFinishedCacheOfAnotherRunStaysUntilThisOneIsDone) {
    FrameStore first = store("other");
    run(first, 3);
    first.finish();
    FrameStore s = store();
    EXPECT_EQ(s.frames_done(), 0);
    run(s, 2);
    EXPECT_EQ(guide_cache_info(path).frames, 3);
    s.finish();
    EXPECT_EQ(guide_cache_info(path).frames, 2);
    EXPECT_EQ(store("job", true).frames_done(), 0);
}

TEST_F(StoredFrames, AKillWhileTheFolderIsRemovedLosesNothing) {
    FrameStore first = store();
    run(first, kFrames);
    const TemporaryFolder kept;
    std::filesystem::copy(frames, kept.path);
    first.finish();
    // As if killed after the first two files.
    std::filesystem::create_directory(frames);
    for (const char* name : {"000043.h5", "000046.h5"}) {
        std::filesystem::copy(kept / name, frames / name);
    }
    FrameStore s = store();
    EXPECT_EQ(s.frames_done(), kFrames);
    s.finish();
    EXPECT_FALSE(std::filesystem::exists(frames));
    EXPECT_EQ(read_bytes(path), whole_run());
}

TEST_F(StoredFrames, ARunKilledAtAnyMomentGivesTheSameBytes) {
    const std::string whole = whole_run();
    // Killed after 0.2 ms, 0.4 ms, ...; a whole run takes about 10 ms.
    for (int i = 1; i <= 60; ++i) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            FrameStore s = store();
            run(s, kFrames);
            s.finish();
            std::filesystem::remove(path);  // so that the next starts over
            _exit(0);
        }
        std::this_thread::sleep_for(std::chrono::microseconds(200 * i));
        kill(child, SIGKILL);
        int status = 0;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        if (i % 4 != 0) continue;  // up to four kills before it ends
        FrameStore s = store();
        run(s, kFrames);
        s.finish();
        ASSERT_EQ(read_bytes(path), whole) << i;
        ASSERT_FALSE(std::filesystem::exists(frames)) << i;
        std::filesystem::remove(path);
    }
}

TEST_F(StoredFrames, OtherFilesInTheFolderStay) {
    FrameStore s = store();
    run(s, 2);
    write_bytes(frames / "notes.txt", "mine");
    write_bytes(frames / "000043.tmp-12-0.h5", "left by a kill");
    FrameStore again = store();
    EXPECT_FALSE(std::filesystem::exists(frames / "000043.tmp-12-0.h5"));
    again.finish();
    EXPECT_EQ(read_bytes(frames / "notes.txt"), "mine");
    EXPECT_FALSE(std::filesystem::exists(frames / "000041.h5"));
}

TEST_F(StoredFrames, RejectsFramesThatReadingWouldReject) {
    FrameStore s = store();
    const auto refused = [&](auto change) {
        Guides guides = guides_at(1);
        change(guides);
        EXPECT_THROW(s.add(guides, {}), std::invalid_argument);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    refused([&](Guides& g) { g.curvatures[3].y() = nan; });
    refused([&](Guides& g) { g.root_positions[1].x() = nan; });
    refused([&](Guides& g) { g.root_frames[2](0, 0) += 0.01; });
    refused([&](Guides& g) { g.segment_lengths[0] += 1e-9; });
    EXPECT_THROW(s.add(guides_at(1), {{"a/b", {1}}}), std::invalid_argument);
    EXPECT_THROW(s.add(guides_at(1), {{"", {1}}}), std::invalid_argument);
    EXPECT_THROW(s.add(guides_at(1), {{"a", {nan}}}), std::invalid_argument);
    EXPECT_EQ(s.frames_done(), 0);
    EXPECT_TRUE(std::filesystem::is_empty(frames));
}

TEST_F(StoredFrames, AnUnwritableCacheIsAnInputErrorAtOnce) {
    const auto error_at = [&](const std::filesystem::path& to) {
        return input_error([&] { FrameStore(to, {}, "job", guides_at(0)); });
    };
    EXPECT_THAT(error_at(folder / "none/cache.h5"), HasSubstr("there is no folder"));
    EXPECT_THAT(error_at(folder.path), HasSubstr("it is a folder"));
    write_bytes(frames, "a file");
    EXPECT_THAT(error_at(path), HasSubstr("cache.h5.frames: must be a folder"));
}

TEST_F(StoredFrames, NegativeFrameNumbersHaveFileNames) {
    FrameStore s(path, {24, -1, ""}, "job", guides_at(0));
    run(s, 3);
    EXPECT_TRUE(std::filesystem::exists(frames / "-00001.h5"));
    EXPECT_TRUE(std::filesystem::exists(frames / "000001.h5"));
    FrameStore again(path, {24, -1, ""}, "job", guides_at(0));
    EXPECT_EQ(again.frames_done(), 3);
    EXPECT_EQ(again.last().number, 1);
}

}  // namespace
}  // namespace lancret
