// lancret evaluate.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "procedural/expand/expand.h"
#include "tests/tools/small_grooms.h"

namespace lancret {
namespace {

using testing::HasSubstr;

TEST(Evaluate, JsonHasEveryFigureOfEveryBlend) {
    const SmallGrooms folder;
    const std::string file = folder.at("figures.json");
    const CommandRun run =
        lancret({"evaluate", folder.hair, "--guides", "9", "--json", file});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto json = nlohmann::json::parse(read_bytes(file));
    EXPECT_EQ(json["default"], blend_name(ExpandSettings{}.blend));
    EXPECT_EQ(json["guides"], 9);
    EXPECT_EQ(json["strands"], 25);
    EXPECT_EQ(json["blends"].size(), blends().size());
    for (const BlendTraits& entry : blends()) {
        EXPECT_THAT(run.out, HasSubstr(std::string(entry.name)));
        const auto& blend = json["blends"][std::string(entry.name)];
        for (const char* figure :
             {"/rms_over_length/median", "/rms_over_length/p95", "/place/median",
              "/place/p95", "/tip_distance/median", "/length_error/mean",
              "/length_error/max", "/curvature/w1", "/curvature/mean_ratio",
              "/torsion/w1", "/ns_per_point"}) {
            EXPECT_TRUE(blend.at(nlohmann::json::json_pointer(figure)).is_number())
                << entry.name << figure;
        }
        EXPECT_TRUE(blend.at("code").is_string());
        // All hairs of the lawn are the same, 5 cm long: the remaining error is round-off
        // of file and blend and the distance of a guide from its strand.
        EXPECT_LT(blend["rms_over_length"]["p95"], 0.002 + 1e-5) << entry.name;
    }
}

TEST(Evaluate, OnlyNamedBlendsAreEvaluatedEachOnce) {
    const SmallGrooms folder;
    const std::string file = folder.at("figures.json");
    const CommandRun run = lancret({"evaluate", "--blend", "position,option1,position",
                                    folder.hair, "--guides", "20%", "--json", file});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto json = nlohmann::json::parse(read_bytes(file));
    EXPECT_EQ(json["guides"], 5);
    EXPECT_EQ(json["blends"].size(), 2u);
    EXPECT_LT(run.out.find("position "), run.out.rfind("option1 "));
}

TEST(Evaluate, AllFiguresButTheCostAreReproducible) {
    const SmallGrooms folder;
    const auto figures = [&](const std::string& seed) {
        const std::string file = folder.at("figures.json");
        const CommandRun run =
            lancret({"evaluate", folder.hair, "--guides", "9", "--curl", "0.03,4,0.2",
                     "--seed", seed, "--json", file});
        EXPECT_EQ(run.exit_code, 0) << run.err;
        auto json = nlohmann::json::parse(read_bytes(file));
        for (auto& blend : json["blends"]) blend.erase("ns_per_point");
        return json;
    };
    const auto first = figures("5");
    EXPECT_EQ(first, figures("5"));
    EXPECT_NE(first["blends"], figures("6")["blends"]);
    EXPECT_EQ(first["curl"]["turns"], 4);
}

TEST(Evaluate, ReadsAGroomWithItsScalp) {
    const SmallGrooms folder;
    EXPECT_EQ(lancret({"evaluate", folder.made}).exit_code, 0);
    const CommandRun run =
        lancret({"evaluate", folder.hair, "--scalp", folder.obj, "--guides", "9"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST(Evaluate, StripHasOnePanelForTheTruthAndEachBlend) {
    const SmallGrooms folder;
    const std::string file = folder.at("strip.png");
    const CommandRun run =
        lancret({"evaluate", folder.hair, "--guides", "9", "--blend", "option1,position",
                 "--image", file, "--size", "24x30", "--samples", "1"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const std::string bytes = read_bytes(file);
    ASSERT_GT(bytes.size(), 24u);
    // A PNG header has the size from byte 16 on, big-endian.
    EXPECT_EQ(bytes.substr(1, 3), "PNG");
    EXPECT_EQ(static_cast<unsigned char>(bytes[19]), 3 * 24);
    EXPECT_EQ(static_cast<unsigned char>(bytes[23]), 30);
}

TEST(Evaluate, UnknownBlendIsNamedWithTheKnownOnes) {
    const SmallGrooms folder;
    EXPECT_THAT(lancret({"evaluate", folder.hair, "--blend", "option1,mean"}),
                refuses_with("--blend", "'mean'", "option1", "position"));
    EXPECT_THAT(lancret({"evaluate", folder.hair, "--blend", "option1,"}),
                refuses_with("--blend", "''"));
}

TEST(Evaluate, CurlIsThreeNumbersInTheirRange) {
    const SmallGrooms folder;
    for (const char* curl : {"0.02,8", "0.02,8,0.1,1", "0.02,8,x", "0.02,8,", "-0.1,8,0",
                             "0.1,101,0", "0.1,8,1.5", "nan,8,0", "0.02 ,8,0"}) {
        EXPECT_THAT(lancret({"evaluate", folder.hair, "--curl", curl}),
                    refuses_with("--curl"))
            << curl;
    }
}

TEST(Evaluate, NothingToPredictIsRefused) {
    const SmallGrooms folder;
    EXPECT_THAT(lancret({"evaluate", folder.hair, "--guides", "25"}),
                refuses_with("lawn.hair", "25 of its 25", "--guides"));
    EXPECT_THAT(lancret({"evaluate", folder.hair, "--guides", "100%"}),
                refuses_with("--guides"));
}

TEST(Evaluate, GuidesWithoutStrandsAreRefused) {
    const SmallGrooms folder;
    const std::string cache = folder.at("g.h5");
    ASSERT_EQ(lancret({"fit", folder.hair, "--guides", "4", "-o", cache}).exit_code, 0);
    EXPECT_EQ(lancret({"evaluate", cache}).exit_code, 2);
}

TEST(Evaluate, OutputsThatCannotBeWrittenAreRefusedBeforeAnyWork) {
    const SmallGrooms folder;
    const std::string json = folder.at("a.json");
    EXPECT_THAT(lancret({"evaluate", folder.hair, "--json", folder.at("no/a.json")}),
                refuses_with("no/a.json"));
    EXPECT_THAT(
        lancret({"evaluate", folder.hair, "--json", json, "--image", folder.at("a.jpg")}),
        refuses_with("a.jpg", ".png"));
    EXPECT_THAT(lancret({"evaluate", folder.hair, "--json", folder.at("a.png"), "--image",
                         folder.at("a.png")}),
                refuses_with("a.png"));
    EXPECT_THAT(lancret({"evaluate", folder.hair, "--json", folder.hair}),
                refuses_with("lawn.hair"));
    EXPECT_FALSE(std::filesystem::exists(json));
}

TEST(Evaluate, ValueOutOfRangeIsNamedWithItsOption) {
    const SmallGrooms folder;
    const auto expect_error = [&](const char* option, const char* value) {
        EXPECT_THAT(lancret({"evaluate", folder.hair, option, value}),
                    refuses_with(option))
            << value;
    };
    expect_error("--seed", "-1");
    expect_error("--segments", "0");
    expect_error("--guides", "0");
    expect_error("--size", "64");
    expect_error("--samples", "0");
}

}  // namespace
}  // namespace lancret
