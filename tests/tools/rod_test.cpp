// Runs `lancret rod`.

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/tools/small_grooms.h"

namespace lancret {
namespace {

/// Runs `lancret rod` with `words` and reads its JSON.
nlohmann::json rod_json(std::vector<std::string> words) {
    const TemporaryFolder folder;
    const std::string file = (folder / "rod.json").string();
    words.insert(words.begin(), "rod");
    words.insert(words.end(), {"--json", file});
    const CommandRun run = lancret(words);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return nlohmann::json::parse(read_bytes(file));
}

TEST(RodCommand, DefaultsAreAWeightlessHorizontalRod) {
    const nlohmann::json rod = rod_json({});
    EXPECT_EQ(rod["gamma"], 0);
    EXPECT_EQ(rod["segments"], 20);
    EXPECT_NEAR(rod["tip"][0], 1, 1e-14);
    EXPECT_EQ(rod["root_normal"], nlohmann::json({0., 0., 1.}));
    EXPECT_EQ(rod["root_curvature"], 0);
    EXPECT_EQ(rod["stable"], true);
    EXPECT_EQ(rod["critical_gamma"], nullptr);
}

TEST(RodCommand, HeavyElasticaIsTheReferenceToSecondOrder) {
    // The drop at gamma 10 is 0.7001997155; 40 segments are off by 1.06e-4, a quarter of
    // the error of 20.
    const auto error = [](const char* segments) {
        const nlohmann::json rod = rod_json({"--gamma", "10", "--segments", segments});
        return rod["lowest"].get<double>() + 0.7001997155;
    };
    const double coarse = error("20"), fine = error("40");
    EXPECT_NEAR(coarse / fine, 4, 0.05);
    EXPECT_NEAR(fine, 1.06e-4, 1e-6);
}

TEST(RodCommand, RingHangsAtItsReference) {
    // The error falls as N^-2: 4.2e-5 for 40 segments, as in the tests of the library.
    const nlohmann::json rod =
        rod_json({"--gamma", "100", "--natural", "0,0,6.283185307179586",
                  "--root-tangent=0,0,-1", "--root-normal", "1,0,0", "--segments", "40"});
    EXPECT_NEAR(rod["tip"][0], 0.31627190, 5e-5);
    EXPECT_NEAR(rod["tip"][2], -0.80261203, 5e-5);
    EXPECT_NEAR(rod["lowest"], -0.81654418, 5e-5);
    EXPECT_LT(rod["lowest_at"], 0.999);
}

TEST(RodCommand, ModesAndBucklingAreWritten) {
    // The values of 20 segments for 3.516015 (+0.05 %), in both planes, and 7.837347.
    const nlohmann::json rod =
        rod_json({"--root-tangent", "0,0,1", "--modes", "4", "--buckling"});
    ASSERT_EQ(rod["modes"].size(), 4u);
    EXPECT_NEAR(rod["modes"][0], 3.517718, 1e-6);
    EXPECT_NEAR(rod["modes"][1], 3.517718, 1e-6);
    EXPECT_NEAR(rod["critical_gamma"], 7.843407, 1e-6);
    EXPECT_EQ(rod["stability_changes"][0]["stable"], false);
}

TEST(RodCommand, NormalIsMadePerpendicular) {
    const nlohmann::json rod =
        rod_json({"--root-tangent", "0,3,0", "--root-normal", "2,7,0"});
    EXPECT_EQ(rod["root_normal"], nlohmann::json({1., 0., 0.}));
    EXPECT_EQ(rod["root_tangent"], nlohmann::json({0., 1., 0.}));
}

TEST(RodCommand, PictureIsWritten) {
    const TemporaryFolder folder;
    const std::string file = (folder / "ring.png").string();
    const CommandRun run =
        lancret({"rod", "--natural", "1,0,5", "--gamma", "5", "-o", file});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(read_bytes(file), testing::StartsWith("\x89PNG"));
}

TEST(RodCommand, PrintsTheSameTwice) {
    const std::vector<std::string> words = {
        "rod", "--gamma",        "30",     "--natural", "0,0,6.283", "--modes",
        "5",   "--root-tangent", "0,0,-1", "--buckling"};
    const CommandRun first = lancret(words);
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_EQ(first.out, lancret(words).out);
}

TEST(BadRodOption, IsNamedInOneLine) {
    const auto rejects = [](const char* option, const char* value) {
        EXPECT_THAT(lancret({"rod", option, value}), refuses_with(option)) << value;
    };
    for (const char* gamma : {"-1", "nan", "inf", "1e7", "ten"}) {
        rejects("--gamma", gamma);
    }
    for (const char* count : {"0", "201", "2.5"}) rejects("--segments", count);
    for (const char* natural : {"1,2", "1,2,3,4", "nan,0,0", "0,0,1e5"}) {
        rejects("--natural", natural);
    }
    for (const char* tangent : {"0,0,0", "inf,0,0", "1,,0"}) {
        rejects("--root-tangent", tangent);
    }
    for (const char* normal : {"1,0,0", "-2,0,0", "0,0,0"}) {
        rejects("--root-normal", normal);
    }
    for (const char* ratio : {"0", "-1", "nan"}) {
        rejects("--torsion-ratio", ratio);
        rejects("--bending-ratio", ratio);
    }
    for (const char* modes : {"0", "-3"}) rejects("--modes", modes);
    EXPECT_THAT(lancret({"rod", "--json", "/no/such/folder/a.json"}),
                refuses_with("/no/such/folder"));
    EXPECT_THAT(lancret({"rod", "-o", "rod.bmp"}), refuses_with("rod.bmp", ".png"));
}

}  // namespace
}  // namespace lancret
