// Caches of several frames: which frame is rendered, checked and written.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "guides/files/frame_store.h"
#include "guides/files/hair_file.h"
#include "tests/tools/reports.h"
#include "tests/tools/small_grooms.h"

namespace lancret {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// made.toml, and cache.h5 with its guides in frames 11 to 13, bent more in each.
struct Bent : SmallGrooms {
    std::string cache = at("cache.h5");
    Guides rest;

    Bent() {
        const std::string fit = at("fit.h5");
        EXPECT_THAT(lancret({"fit", made, "-o", fit}), works());
        rest = read_guide_cache(fit, 0);
        write({at_frame(1), at_frame(2), at_frame(3)});
    }
    Guides at_frame(int k) const {
        Guides out = rest;
        for (Vec3& u : out.curvatures) u += Vec3(0, 0.01 * k, 0.02 * k);
        return out;
    }
    void write(const std::vector<Guides>& frames) const {
        FrameStore store(cache, {24, 11, made}, "bent", rest, true);
        for (const Guides& frame : frames) store.add(frame, {});
        store.finish();
    }
    CommandRun preview(const std::vector<std::string>& words) const {
        std::vector<std::string> all{"preview", cache};
        all.insert(all.end(), words.begin(), words.end());
        return lancret(all);
    }
};

TEST(Frames, PreviewWritesEachFrameByItsNumber) {
    const Bent f;
    ASSERT_THAT(f.preview({"--frames", "11-13", "-o", f.at("a.####.png"), "--stats",
                           f.at("stats.json")}),
                works());
    const std::string first = read_bytes(f / "a.0011.png");
    const std::string last = read_bytes(f / "a.0013.png");
    ASSERT_FALSE(first.empty());
    ASSERT_FALSE(last.empty());
    EXPECT_NE(first, last);
    EXPECT_TRUE(std::filesystem::exists(f / "a.0012.png"));
    const auto stats = json_of(f.at("stats.json"));
    ASSERT_EQ(stats["frames"].size(), 3u);
    EXPECT_EQ(stats["frames"][1]["frame"], 12);
    EXPECT_EQ(stats["frames"][1]["image"], f.at("a.0012.png"));
    // A single frame is the same picture: camera and binding do not depend on the range.
    ASSERT_THAT(f.preview({"--frame", "13", "-o", f.at("alone.png")}), works());
    EXPECT_EQ(read_bytes(f / "alone.png"), last);
    // Without an option, the first frame.
    ASSERT_THAT(f.preview({"-o", f.at("default.png")}), works());
    EXPECT_EQ(read_bytes(f / "default.png"), first);
}

TEST(Frames, ATurntableGrowsStrandsOnce) {
    const Bent f;
    ASSERT_THAT(f.preview({"--frame", "12", "--turntable", "3", "-o", f.at("t.##.png"),
                           "--stats", f.at("t.json")}),
                works());
    ASSERT_THAT(f.preview({"--frame", "12", "-o", f.at("front.png")}), works());
    // The first view is the one without a turntable; the others show other sides.
    EXPECT_EQ(read_bytes(f / "t.01.png"), read_bytes(f / "front.png"));
    EXPECT_NE(read_bytes(f / "t.02.png"), read_bytes(f / "t.01.png"));
    EXPECT_NE(read_bytes(f / "t.03.png"), read_bytes(f / "t.02.png"));
    const auto views = json_of(f.at("t.json"))["frames"];
    ASSERT_EQ(views.size(), 3u);
    EXPECT_GT(views[0]["seconds"]["bvh"], 0);
    EXPECT_EQ(views[1]["seconds"]["bvh"], 0);
    EXPECT_EQ(views[2]["seconds"]["expand"], 0);
    EXPECT_EQ(f.preview({"--frames", "11-13", "--turntable", "3", "-o", f.at("no.png")})
                  .exit_code,
              2);
}

TEST(Frames, ATurntableDrawsThinStrandsWiderInEveryView) {
    const Bent f;
    const std::string wide =
        f.file("wide.toml", read_bytes(f.made) + "min_width_pixels = 2\n");
    for (const auto& [groom, picture] :
         {std::pair{f.made, "t.##.png"}, std::pair{wide, "w.##.png"}}) {
        ASSERT_THAT(lancret({"preview", groom, "--turntable", "2", "-o", f.at(picture)}),
                    works());
    }
    EXPECT_NE(read_bytes(f / "w.01.png"), read_bytes(f / "t.01.png"));
    EXPECT_NE(read_bytes(f / "w.02.png"), read_bytes(f / "t.02.png"));
}

TEST(Frames, AProgressivePictureEndsInTheSameBytes) {
    const Bent f;
    ASSERT_THAT(f.preview({"--samples", "3", "-o", f.at("at_once.png")}), works());
    ASSERT_THAT(f.preview({"--samples", "3", "--progressive", "-o", f.at("by_parts.png"),
                           "--stats", f.at("parts.json")}),
                works());
    EXPECT_EQ(read_bytes(f / "by_parts.png"), read_bytes(f / "at_once.png"));
    const auto stats = json_of(f.at("parts.json"));
    EXPECT_GT(stats["seconds"]["first_picture"], 0);
    EXPECT_LT(stats["seconds"]["first_picture"], stats["seconds"]["render"]);
    EXPECT_GT(stats["rays"], 0);
}

TEST(Frames, NumbersReplaceThePattern) {
    const Bent f;
    const auto writes = [&](const char* frames, const char* output, const char* file) {
        const CommandRun run =
            f.preview({"--frames", frames, "--samples", "1", "-o", f.at(output)});
        return run.exit_code == 0 && std::filesystem::exists(f / file);
    };
    EXPECT_TRUE(writes("12-13", "plain.png", "plain.0012.png"));
    EXPECT_TRUE(std::filesystem::exists(f / "plain.0013.png"));
    EXPECT_FALSE(std::filesystem::exists(f / "plain.png"));
    EXPECT_TRUE(writes("12", "one.png", "one.png"));
    EXPECT_TRUE(writes("12", "c%06dx.png", "c000012x.png"));
    EXPECT_TRUE(writes("12", "#.png", "12.png"));
}

TEST(Frames, AMissingFrameIsAnErrorThatListsTheFrames) {
    const Bent f;
    const std::string png = f.at("a.png");
    EXPECT_THAT(f.preview({"--frame", "10", "-o", png}),
                refuses_with("--frame: ", "has no frame 10; it has frames 11 to 13"));
    EXPECT_THAT(f.preview({"--frames", "12-20", "-o", png}),
                refuses_with("--frames: ", "no frame 20; it has frames 11 to 13"));
    EXPECT_THAT(lancret({"check", f.cache, "--frame", "14"}),
                refuses_with("no frame 14; it has frames 11 to 13"));
    EXPECT_THAT(lancret({"expand", f.cache, "--frame", "0"}), refuses_with("no frame 0"));
    EXPECT_THAT(lancret({"preview", f.made, "--frame", "1", "-o", png}),
                refuses_with("--frame", "made.toml is not a guide cache"));
    for (const char* text : {"13-12", "a", "1-", "1-2-3", "99999999999", "1 -2"}) {
        EXPECT_THAT(f.preview({"--frames", text, "-o", png}),
                    refuses_with("--frames", text));
    }
    EXPECT_THAT(f.preview({"--frames", "11", "--frame", "11", "-o", png}),
                refuses_with("--frame"));
}

TEST(Frames, ExpandGrowsTheFrameOnTheRootsOfTheRest) {
    const Bent f;
    const auto strands = [&](const std::string& input, const std::string& frame) {
        const std::string hair = f.at("out.hair");
        // Without --intervals they differ: a cache is measured at all of its frames.
        std::vector<std::string> words{"expand", input, "-o", hair, "--intervals", "48"};
        if (!frame.empty()) words.insert(words.end(), {"--frame", frame});
        EXPECT_THAT(lancret(words), works());
        return read_hair(hair);
    };
    const Strands rest = strands(f.made, ""), first = strands(f.cache, ""),
                  last = strands(f.cache, "13");
    ASSERT_EQ(first.size(), 60u);
    ASSERT_EQ(first.points.size(), rest.points.size());
    double moved = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(first.strand(i).front(), rest.strand(i).front());
        EXPECT_EQ(last.strand(i).front(), rest.strand(i).front());
        moved += double((last.strand(i).back() - first.strand(i).back()).norm());
    }
    // Tips of hairs of 30 cm, bent by another 0.045 / cm, move far more than 1 cm.
    EXPECT_GT(moved / 60, 1);
    EXPECT_EQ(strands(f.cache, "11").points, first.points);
}

TEST(Frames, BetweenFramesHairIsBetween) {
    const Bent f;
    const auto tips = [&](const std::string& frame) {
        const std::string hair = f.at("out.hair");
        EXPECT_THAT(lancret({"expand", f.cache, "--frame", frame, "--blend", "position",
                             "-o", hair}),
                    works());
        const Strands strands = read_hair(hair);
        Eigen::Matrix3Xf out(3, strands.size());
        for (std::size_t i = 0; i < strands.size(); ++i) {
            out.col(Eigen::Index(i)) = strands.strand(i).back();
        }
        return out;
    };
    const auto a = tips("12"), b = tips("12.25"), c = tips("13");
    const float whole = (c - a).colwise().norm().mean(),
                part = (b - a).colwise().norm().mean();
    // The bend increases evenly: a quarter of the way, except that tips move on arcs.
    EXPECT_GT(part, 0.2f * whole);
    EXPECT_LT(part, 0.35f * whole);
    EXPECT_THAT(lancret({"check", f.cache, "--frame", "12.25", "--distance", "1"}),
                works());
    EXPECT_THAT(f.preview({"--frame", "12.25", "--samples", "1", "-o", f.at("p.##.png")}),
                works());
    EXPECT_TRUE(std::filesystem::exists(f / "p.12.25.png"));
    EXPECT_THAT(f.preview({"--frame", "13.5", "-o", f.at("a.png")}),
                refuses_with("no frame 13.5; it has frames 11 to 13"));
    for (const char* number : {"nan", "inf", "-1e300"}) {
        EXPECT_THAT(f.preview({"--frame", number, "-o", f.at("a.png")}),
                    refuses_with("--frame"))
            << number;
    }
}

TEST(Frames, AShutterBlursWhatMoves) {
    const Bent f;
    const auto picture = [&](std::vector<std::string> words, const char* message) {
        words.insert(words.end(), {"-o", f.at("a.png"), "--stats", f.at("stats.json")});
        const CommandRun run = f.preview(words);
        EXPECT_THAT(run, works());
        EXPECT_THAT(run.err, HasSubstr(message));
        return read_bytes(f / "a.png");
    };
    const auto times = [&] {
        return json_of(f.at("stats.json"))["frames"][0]["times"]
            .get<std::vector<double>>();
    };
    const std::string still = picture({"--frame", "12"}, "");
    const std::string blurred = picture(
        {"--frame", "12", "--shutter", "-0.25,0.25", "--motion-samples", "5"}, "");
    EXPECT_EQ(times(), (std::vector<double>{11.75, 11.875, 12, 12.125, 12.25}));
    EXPECT_NE(blurred, still);
    // An empty shutter interval is no shutter.
    EXPECT_EQ(picture({"--frame", "12", "--shutter", "0,0"}, ""), still);
    EXPECT_EQ(times(), std::vector<double>{12});
    // The shutter is clipped to the cache.
    picture({"--frame", "13", "--shutter", "-0.5,0.5"},
            "warning: frame 13: the cache has frames 11 to 13, and the shutter is cut "
            "to 12.5 to 13");
    EXPECT_EQ(times(), (std::vector<double>{12.5, 12.75, 13}));
    for (const char* text : {"", "0", "0,", "0.5,0", "0,1,2", "a,b", "nan,1", "0,1e9"}) {
        EXPECT_THAT(f.preview({"--shutter", text, "-o", f.at("b.png")}),
                    refuses_with("--shutter"))
            << text;
    }
    EXPECT_THAT(lancret({"preview", f.made, "--shutter", "0,1", "-o", f.at("b.png")}),
                refuses_with("--shutter: only a cache"));
}

TEST(Frames, CheckReportsHowFarChildrenMoveComparedWithTheirGuides) {
    const Bent f;
    const std::string json = f.at("check.json");
    const CommandRun run =
        lancret({"check", f.cache, "--blend", "position", "--json", json, "--distance",
                 "9", "--emitted-length", "1", "--length", "1"});
    const auto motion = json_of(json)["motion"];
    ASSERT_EQ(motion["steps"].size(), 2u);
    EXPECT_LE(motion["share_of_limit"], 1 + 1e-6);
    EXPECT_LE(motion["amplification"], 1 + 1e-6);
    EXPECT_GT(motion["amplification"], 0.5);
    EXPECT_THAT(run.out, HasSubstr("child's step over its guides'"));
}

TEST(Frames, CheckMeasuresEveryFrameAndNamesTheWorst) {
    const Bent f;
    const std::string json = f.at("check.json");
    // Guides of six segments bend sharply at their joints and need a larger tolerance.
    const CommandRun run = lancret({"check", f.cache, "--json", json, "--distance", "1"});
    ASSERT_THAT(run, works());
    EXPECT_THAT(run.out, HasSubstr("PASS: all 3 frames keep every tolerance"));
    const auto report = json_of(json);
    EXPECT_TRUE(report["pass"]);
    ASSERT_EQ(report["frames"].size(), 3u);
    EXPECT_EQ(report["frames"][2]["frame"], 13);
    const double largest = report["worst_over_frames"]["length"]["max_relative_error"];
    double expected = 0;
    for (const auto& frame : report["frames"]) {
        expected = std::max<double>(expected, frame["length"]["max_relative_error"]);
    }
    EXPECT_EQ(largest, expected);
    // Reading projects the rest roots onto the scalp: round-off of doubles of 15 cm.
    EXPECT_LE(report["worst_over_frames"]["guides"]["root_cm"]["max"], 1e-13);
    ASSERT_THAT(
        lancret({"check", f.cache, "--frames", "12", "--json", json, "--distance", "1"}),
        works());
    EXPECT_EQ(json_of(json)["frames"].size(), 1u);
}

TEST(Frames, CheckFindsTheFrameWhoseGuidesLeaveTheScalp) {
    Bent f;
    std::vector<Guides> frames{f.at_frame(1), f.at_frame(2), f.at_frame(3)};
    frames[1].root_positions[7] += Vec3(0, 0.5, 0);
    f.write(frames);
    const std::string json = f.at("check.json");
    const CommandRun run = lancret({"check", f.cache, "--json", json, "--distance", "1"});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.out, HasSubstr("FAIL: 1 of 3 frames exceed a tolerance, the first "
                                   "is 12"));
    const auto report = json_of(json);
    EXPECT_FALSE(report["pass"]);
    EXPECT_TRUE(report["frames"][0]["pass"]);
    EXPECT_FALSE(report["frames"][1]["pass"]);
    EXPECT_EQ(report["frames"][1]["guides"]["root_guide"], 7);
    const auto& root = report["worst_over_frames"]["guides"]["root_cm"];
    EXPECT_EQ(root["frame"], 12);
    EXPECT_NEAR(root["max"], 0.5, 1e-9);
}

TEST(Frames, AFrameOfAnUnfinishedRunIsACache) {
    const Bent f;
    FrameStore store(f.at("run.h5"), {24, 1, f.made}, "run", f.rest);
    store.add(f.at_frame(3), {{"rates", {1, 2}}});
    const std::string frame = store.frame_file(0).string();
    EXPECT_THAT(lancret({"preview", frame, "--samples", "1", "-o", f.at("a.png")}),
                works());
    const CommandRun info = lancret({"info", frame});
    ASSERT_THAT(info, works());
    EXPECT_THAT(info.out, HasSubstr("a simulation can continue from the last frame"));
}

TEST(Frames, InfoPrintsFramesRateAndGroom) {
    const Bent f;
    const std::string json = f.at("info.json");
    const CommandRun info = lancret({"info", f.cache, "--stats", json});
    ASSERT_THAT(info, works());
    EXPECT_THAT(info.out,
                AllOf(HasSubstr("3 frames from 11 at 24 fps"),
                      HasSubstr("groom: " + f.made), HasSubstr("rest pose: stored")));
    const auto stats = json_of(json);
    EXPECT_EQ(stats["last_frame"], 13);
    EXPECT_EQ(stats["groom"], f.made);
}

TEST(Frames, ACacheOfOneFrameByFitIsBoundAtItsFrame) {
    const Bent f;
    const CommandRun run = lancret({"check", f.at("fit.h5"), "--distance", "1"});
    ASSERT_THAT(run, works());
    EXPECT_THAT(run.out, HasSubstr("PASS: all 1 frames"));
    EXPECT_THAT(run.out, HasSubstr("not checked"));
}

}  // namespace
}  // namespace lancret
