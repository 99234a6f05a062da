// `lancret simulate` from groom to pictures, killed and continued.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "guides/files/guide_cache.h"
#include "guides/helix/super_helix.h"
#include "tests/tools/simulate_runs.h"

namespace lancret {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// The largest distance between the tips of two states of the same guides.
double tip_distance(const Guides& a, const Guides& b) {
    double out = 0;
    for (std::size_t g = 0; g < a.size(); ++g) {
        const auto tip = [g](const Guides& guides) {
            return state_at(super_helix(guides, g), guide_length(guides, g)).position;
        };
        out = std::max(out, (tip(a) - tip(b)).norm());
    }
    return out;
}

TEST(Simulate, MakesACacheWhoseFramesPassTheCheckAndShowTheHeadsMotion) {
    const MovingGroom f;
    const std::string stats = f.at("stats.json"), json = f.at("check.json");
    const CommandRun run = f.simulate("1-8", f.cache, {"--stats", stats});
    ASSERT_THAT(run, works());
    EXPECT_THAT(run.out, HasSubstr("40 guides of 6 segments, frames 1-8; 7 simulated"));
    EXPECT_EQ(json_of(stats)["unsolved_steps"], 0);
    EXPECT_EQ(json_of(stats)["frames"]["simulated"], 7);
    EXPECT_GE(json_of(stats)["steps"], 40 * 4 * 7);
    EXPECT_FALSE(std::filesystem::exists(f / "cache.h5.frames"));
    const GuideCacheInfo info = guide_cache_info(f.cache);
    EXPECT_EQ(info.frames, 8);
    EXPECT_TRUE(info.has_rest && info.has_restart);
    // The first frame is the groom; then it moves.
    EXPECT_LT(tip_distance(read_guide_cache(f.cache, 0), read_rest_guides(f.cache)),
              1e-12);
    EXPECT_GT(tip_distance(read_guide_cache(f.cache, 7), read_rest_guides(f.cache)), 1);

    ASSERT_THAT(lancret({"check", f.cache, "--json", json, "--distance", "1"}), works());
    const auto report = json_of(json);
    EXPECT_TRUE(report["pass"]);
    EXPECT_EQ(report["frames"].size(), 8u);
    EXPECT_LE(report["worst_over_frames"]["guides"]["root_cm"]["max"], 1e-9);
    EXPECT_EQ(report["worst_over_frames"]["guides"]["length_change"]["max"], 0);

    for (const char* frame : {"1", "6"}) {
        ASSERT_THAT(lancret({"preview", f.cache, "--frame", frame, "-o",
                             f.at(std::string(frame) + ".png")}),
                    works());
    }
    EXPECT_NE(read_bytes(f / "1.png"), read_bytes(f / "6.png"));
}

TEST(Simulate, KilledAtAnyMomentAndContinuedWritesTheSameBytes) {
    const MovingGroom f;
    const std::string whole = f.at("whole.h5");
    const auto begun = std::chrono::steady_clock::now();
    ASSERT_THAT(f.simulate("1-80", whole), works());
    const auto takes = std::chrono::duration_cast<std::chrono::microseconds>(
        std::chrono::steady_clock::now() - begun);
    std::mt19937_64 random(1);
    std::vector<std::string> words = f.words("1-80", f.cache);
    words.insert(words.begin(), LANCRET_COMMAND);
    int kills = 0, rounds = 0, frames = 0;
    // Kills each run after a random part of the whole duration, the first at once.
    for (; rounds < 60 && kills < 14; ++rounds) {
        const auto after = std::chrono::microseconds(
            1 +
            random() % std::uint64_t(takes.count() / 4 + takes.count() * rounds / 40));
        const CommandRun run = run_words(words, after);
        if (run.exit_code == 0) {
            // Finished: starts over for the remaining kills.
            EXPECT_EQ(read_bytes(f.cache), read_bytes(whole));
            std::filesystem::remove(f.cache);
            continue;
        }
        ASSERT_EQ(run.exit_code, -SIGKILL) << run.err;
        ++kills;
        std::error_code none;
        for (std::filesystem::directory_iterator at(f.cache + ".frames", none), end;
             !none && at != end; at.increment(none)) {
            ++frames;
        }
    }
    EXPECT_GE(kills, 10);
    EXPECT_GT(frames, 0);  // kills hit the run, not only the start of the command
    ASSERT_THAT(f.simulate("1-80", f.cache), works());
    EXPECT_EQ(read_bytes(f.cache), read_bytes(whole));
    EXPECT_FALSE(std::filesystem::exists(f.cache + ".frames"));
}

TEST(Simulate, ALongerRunContinuesAFinishedOne) {
    const MovingGroom f;
    const std::string whole = f.at("whole.h5");
    ASSERT_THAT(f.simulate("1-16", whole), works());
    ASSERT_THAT(f.simulate("1-8", f.cache), works());
    const CommandRun more = f.simulate("1-16", f.cache);
    ASSERT_THAT(more, works());
    EXPECT_THAT(more.err, HasSubstr("continuing after frame 8"));
    EXPECT_THAT(more.out, HasSubstr("8 simulated"));
    EXPECT_EQ(read_bytes(f.cache), read_bytes(whole));
    // The same run again, and a shorter one, change nothing.
    for (const char* frames : {"1-16", "1-4"}) {
        ASSERT_THAT(f.simulate(frames, f.cache), works());
        EXPECT_EQ(read_bytes(f.cache), read_bytes(whole));
    }
}

TEST(Simulate, OtherSettingsNeedRestartWhileARunIsUnfinished) {
    const MovingGroom f;
    std::vector<std::string> words = f.words("1-2000", f.cache);
    words.insert(words.begin(), LANCRET_COMMAND);
    const std::filesystem::path third = f / "cache.h5.frames/000003.h5";
    for (int ms = 200; ms < 20000 && !std::filesystem::exists(third); ms *= 2) {
        ASSERT_EQ(run_words(words, std::chrono::milliseconds(ms)).exit_code, -SIGKILL);
    }
    ASSERT_TRUE(std::filesystem::exists(third));
    EXPECT_THAT(f.simulate("1-3", f.cache, {"--substeps", "7"}),
                refuses_with("cache.h5.frames/", "another run", "--restart"));
    EXPECT_THAT(f.simulate("1-3", f.cache, {"--fps", "30"}), refuses_with("--restart"));
    EXPECT_THAT(f.simulate("2-3", f.cache), refuses_with("--restart"));
    write_bytes(f.groom, std::string(f.kText) + "[dynamics]\ndrag = 1e-3\n");
    EXPECT_THAT(f.simulate("1-3", f.cache), refuses_with("--restart"));
    EXPECT_TRUE(std::filesystem::exists(third));
    ASSERT_THAT(f.simulate("1-3", f.cache, {"--restart"}), works());
    EXPECT_EQ(guide_cache_info(f.cache).frames, 3);
    EXPECT_FALSE(std::filesystem::exists(third));
    const std::string alone = f.at("alone.h5");
    ASSERT_THAT(f.simulate("1-3", alone), works());
    EXPECT_EQ(read_bytes(f.cache), read_bytes(alone));
}

TEST(Simulate, OneThreadWritesTheSameBytes) {
    const MovingGroom f;
    const std::string one = f.at("one.h5");
    ASSERT_THAT(f.simulate("1-10", f.cache), works());
    std::vector<std::string> words{"taskset", "-c", "0", LANCRET_COMMAND};
    for (const std::string& word : f.words("1-10", one)) words.push_back(word);
    const CommandRun run = run_words(words);
    if (run.exit_code == -1 || run.exit_code == 127) GTEST_SKIP() << "no taskset here";
    ASSERT_THAT(run, works());
    EXPECT_EQ(read_bytes(one), read_bytes(f.cache));
}

/// Writes four OBJ files of the lawn's scalp that bulge more and more.
void write_bulging(const SmallGrooms& f, const char* name) {
    const TriangleMesh rest = square_mesh(4, 3);
    for (int frame = 1; frame <= 4; ++frame) {
        TriangleMesh mesh = rest;
        for (Vec3f& p : mesh.positions) {
            p.z() += 0.3f * float(frame - 1) * std::sin(0.7f * p.x()) * std::cos(p.y());
        }
        char path[64];
        std::snprintf(path, sizeof(path), name, frame);
        write_obj(f / path, mesh);
    }
}

TEST(Simulate, RootsFollowAHeadOfObjFiles) {
    const SmallGrooms f;
    write_bulging(f, "head.%04d.obj");
    const std::string groom =
        f.file("groom.toml",
               "[guides]\nfile = 'lawn.hair'\nsegments = 5\n[scalp]\nfile = 'lawn.obj'\n"
               "[strands]\ncount = 50\n[scene]\nup = 'Z'\n"
               "[render]\nwidth = 32\nheight = 32\nsamples = 2\n"
               "[motion]\nfiles = 'head.%04d.obj'\nfirst = 1\nlast = 4\n");
    const std::string cache = f.at("cache.h5"), json = f.at("check.json");
    ASSERT_THAT(lancret({"simulate", groom, "--frames", "1-6", "-o", cache}), works());
    ASSERT_THAT(lancret({"check", cache, "--json", json, "--distance", "1"}), works());
    const auto worst = json_of(json)["worst_over_frames"]["guides"];
    EXPECT_LE(worst["root_cm"]["max"], 1e-9);
    const Guides rest = read_rest_guides(cache), last = read_guide_cache(cache, 5);
    double moved = 0;
    for (std::size_t g = 0; g < rest.size(); ++g) {
        moved = std::max(moved, (rest.root_positions[g] - last.root_positions[g]).norm());
    }
    EXPECT_GT(moved, 0.5);
    EXPECT_LT(moved, 0.9 + 1e-6);
    ASSERT_THAT(lancret({"preview", cache, "--frame", "4", "-o", f.at("a.png")}),
                works());
    // A missing file is named.
    std::filesystem::remove(f / "head.0003.obj");
    EXPECT_THAT(lancret({"simulate", groom, "--frames", "1-6", "--restart", "-o",
                         f.at("other.h5")}),
                refuses_with("head.0003.obj"));
}

TEST(Simulate, EveryShapeOfColliderKeepsHairOut) {
    const SmallGrooms f;
    // Bodies approach the lawn from the side.
    TriangleMesh ball = sphere_mesh(8);
    for (Vec3f& p : ball.positions) p = 1.5f * p + Vec3f(-3, 2, 3);
    write_obj(f / "ball.obj", ball);
    const std::string head =
        "[guides]\nfile = 'lawn.hair'\nsegments = 5\n[scalp]\nfile = 'lawn.obj'\n"
        "[strands]\ncount = 50\n[scene]\nup = 'Z'\n[dynamics.contact]\nhead = false\n";
    const std::string keys =
        "keys = [{frame = 1}, {frame = 8, move = [4, 0, 0], turn = [0, 0, 5]}]\n";
    const std::pair<const char*, std::string> shapes[] = {
        {"none", ""},
        {"sphere",
         "[[colliders]]\nshape = 'sphere'\ncentre = [-3, 2, 3]\nradius = 1.5\n" + keys},
        {"capsule",
         "[[colliders]]\nshape = 'capsule'\nfrom = [-3, 0, 3]\nto = [-3, 4, 3]\n"
         "radius = 1.5\n" +
             keys},
        {"mesh", "[[colliders]]\nshape = 'mesh'\nfile = 'ball.obj'\n" + keys},
        {"head",
         "[[colliders]]\nshape = 'sphere'\ncentre = [2, 2, 3.5]\nradius = 0.5\n"
         "with_head = true\n"}};
    std::string none;
    for (const auto& [name, text] : shapes) {
        const std::string groom = f.file(std::string(name) + ".toml", head + text);
        const std::string cache = f.at(std::string(name) + ".h5");
        const std::string stats = f.at("stats.json");
        ASSERT_THAT(lancret({"simulate", groom, "--frames", "1-8", "-o", cache, "--stats",
                             stats}),
                    works())
            << name;
        // Without contact it would be 1.5 cm; with it, less than the part of the
        // thickness by which the penalty yields at such speeds.
        EXPECT_LT(json_of(stats)["deepest_penetration_cm"], 0.1) << name;
        EXPECT_EQ(json_of(stats)["unsolved_steps"], 0) << name;
        const double moved =
            tip_distance(read_guide_cache(cache, 7), read_rest_guides(cache));
        if (*name == 'n') {
            EXPECT_LT(moved, 1e-6);
        } else if (std::string_view(name) != "head") {
            EXPECT_GT(moved, 1) << name;
        }
    }
}

}  // namespace
}  // namespace lancret
