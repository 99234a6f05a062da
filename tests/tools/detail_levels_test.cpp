// Chunks, adaptive points, density and level of detail.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "procedural/roots/density.h"
#include "tests/tools/reports.h"
#include "tests/tools/small_grooms.h"

namespace lancret {
namespace {

/// The number of points of strands with n intervals and n + `more` points each.
std::size_t points_of(const nlohmann::json& classes, std::size_t more) {
    std::size_t out = 0;
    for (const nlohmann::json& each : classes) {
        out += each.at("strands").get<std::size_t>() *
               (each.at("intervals").get<std::size_t>() + more);
    }
    return out;
}

TEST(Chunks, ExpandGrowsAndDiscardsThem) {
    const SmallGrooms folder;
    const std::string stats = folder.at("stats.json");
    const CommandRun run =
        lancret({"expand", folder.made, "--strands", "1000", "--chunks",
                 "--chunk-strands", "64", "--stats", stats});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const nlohmann::json json = json_of(stats);
    EXPECT_EQ(json.at("strands"), 1000);
    EXPECT_EQ(json.at("chunks"), 16);  // 1000 / 64, rounded up
    EXPECT_EQ(json.at("points"), points_of(json.at("classes"), 3));
    // 12 bytes per place, 4 per id, and the start of each chunk.
    EXPECT_EQ(json.at("bytes").at("places"), 12000);
    EXPECT_EQ(json.at("bytes").at("chunks"), 4000 + 17 * 4);
    EXPECT_THAT(lancret({"expand", folder.made, "--chunks", "-o", folder.at("a.hair")}),
                refuses_with("--chunks", "-o"));
}

TEST(Chunks, CheckMeasuresTheirBoxes) {
    const SmallGrooms folder;
    const std::string report = folder.at("check.json");
    const CommandRun run =
        lancret({"check", folder.made, "--strands", "5000", "--json", report});
    ASSERT_EQ(run.exit_code, 0) << run.out << run.err;
    const nlohmann::json chunks = json_of(report).at("chunks");
    EXPECT_EQ(chunks.at("count"), 2);
    EXPECT_EQ(chunks.at("outside"), 0);
    EXPECT_EQ(chunks.at("unlike"), 0);
    EXPECT_LT(chunks.at("volume_over_true").at("max"), 1.1);
    EXPECT_GE(chunks.at("volume_over_true").at("mean"), 1);
}

TEST(Adapt, WritesStrandsWithDifferentNumbersOfPoints) {
    const SmallGrooms folder;
    const std::string stats = folder.at("stats.json"), hair = folder.at("a.hair");
    const CommandRun run = lancret(
        {"expand", folder.made, "--strands", "500", "--stats", stats, "-o", hair});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const nlohmann::json json = json_of(stats), classes = json.at("classes");
    EXPECT_EQ(points_of(classes, 1) - points_of(classes, 0), 500);
    EXPECT_EQ(json.at("points"), points_of(classes, 3));
    EXPECT_LT(json.at("points"), json.at("points_alike"));
    EXPECT_EQ(read_hair(hair).points.size(), points_of(classes, 1));
}

TEST(Adapt, CanBeDisabled) {
    const SmallGrooms folder;
    const std::string stats = folder.at("stats.json");
    const std::string toml = folder.file("alike.toml",
                                         "[guides]\nsegments = 6\n[guides.made]\nstrands "
                                         "= 40\n[strands]\nadapt = false\n");
    const auto expect_alike = [&](std::vector<std::string> command) {
        for (const char* more : {"--strands", "500", "--stats", stats.c_str()}) {
            command.emplace_back(more);
        }
        const CommandRun run = lancret(command);
        ASSERT_EQ(run.exit_code, 0) << run.err;
        const nlohmann::json json = json_of(stats);
        EXPECT_EQ(json.at("classes").size(), 1);
        EXPECT_EQ(json.at("points"), json.at("points_alike"));
    };
    expect_alike({"expand", folder.made, "--no-adapt"});
    expect_alike({"expand", folder.made, "--intervals", "9"});
    expect_alike({"expand", folder.made, "-o", folder.at("a.txt")});
    expect_alike({"expand", toml});
}

TEST(Density, GrowsStrandsByRank) {
    const SmallGrooms folder;
    const std::string stats = folder.at("stats.json");
    std::size_t expected = 0;
    for (std::uint32_t i = 0; i < 2000; ++i) {
        expected += width_at(strand_rank(0, i), 0.25) > 0;
    }
    ASSERT_EQ(lancret({"expand", folder.made, "--strands", "2000", "--density", "0.25",
                       "--stats", stats})
                  .exit_code,
              0);
    EXPECT_EQ(json_of(stats).at("strands"), expected);
    const std::string toml =
        folder.file("thin.toml",
                    "[guides]\nsegments = 6\n[guides.made]\nstrands = 40\n"
                    "[strands]\ncount = 2000\ndensity = 0.25\n");
    ASSERT_EQ(lancret({"expand", toml, "--stats", stats}).exit_code, 0);
    EXPECT_EQ(json_of(stats).at("strands"), expected);
    EXPECT_THAT(lancret({"expand", folder.made, "--density", "1e-6"}),
                refuses_with("made.toml", "density"));
}

TEST(Density, PreviewAcceptsItAndALevelOfDetail) {
    const SmallGrooms folder;
    const std::string stats = folder.at("stats.json"), png = folder.at("a.png");
    ASSERT_EQ(lancret({"preview", folder.made, "--strands", "2000", "--density", "0.1",
                       "--stats", stats, "-o", png})
                  .exit_code,
              0);
    const int strands = json_of(stats).at("strands");
    EXPECT_GT(strands, 100);
    EXPECT_LT(strands, 400);
    // The picture has 32 x 32 pixels, so the box of one chunk has fewer.
    const CommandRun lod = lancret({"preview", folder.made, "--strands", "4000", "--lod",
                                    "0.5", "--stats", stats, "-o", png});
    ASSERT_EQ(lod.exit_code, 0) << lod.err;
    const int left = json_of(stats).at("strands");
    EXPECT_LT(left, 512 * 1.1 + 5 * 23);  // five standard deviations of a count of 512
    EXPECT_GT(left, 20);
    EXPECT_THAT(lancret({"preview", folder.made, "--lod", "1e-6", "-o", png}),
                refuses_with("--lod"));
}

}  // namespace
}  // namespace lancret
