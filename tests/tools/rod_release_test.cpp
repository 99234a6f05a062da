// Runs `lancret rod --release`.

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/tools/small_grooms.h"

namespace lancret {
namespace {

nlohmann::json release_json(std::vector<std::string> words, const char* gamma = "10",
                            int exit_code = 0) {
    const TemporaryFolder folder;
    const std::string file = (folder / "rod.json").string();
    words.insert(words.begin(), {"rod", "--gamma", gamma, "--natural", "1,0,5",
                                 "--segments", "5", "--json", file, "--release"});
    const CommandRun run = lancret(words);
    EXPECT_EQ(run.exit_code, exit_code) << run.err;
    return nlohmann::json::parse(read_bytes(file));
}

TEST(RodRelease, SamplesEnergyFromTheFirstMomentToTheLast) {
    const nlohmann::json run = release_json({"2.5", "--dt", "0.001"});
    const nlohmann::json& energy = run["energy"];
    EXPECT_EQ(run["steps"], 2500);
    EXPECT_LE(energy.size(), 1000u);
    EXPECT_GT(energy.size(), 500u);
    EXPECT_EQ(energy.front()["t"], 0);
    EXPECT_EQ(energy.front()["kinetic"], 0);
    EXPECT_EQ(energy.front()["elastic"], 0);
    EXPECT_NEAR(energy.back()["t"], 2.5, 1e-12);
    double largest = 0;
    for (const nlohmann::json& s : energy) {
        const double total = s["total"];
        EXPECT_NEAR(total,
                    s["kinetic"].get<double>() + s["elastic"].get<double>() +
                        s["gravity"].get<double>(),
                    1e-12);
        largest =
            std::max(largest, std::abs(total - energy.front()["total"].get<double>()));
    }
    const double depth = energy.front()["total"].get<double>() -
                         run["equilibrium"]["energy"]["total"].get<double>();
    // The drift covers all steps, not only the samples.
    EXPECT_GE(run["energy_drift"], largest / depth * (1 - 1e-12));
    // BDF2 loses (omega eps)^3 omega / 2 of a mode's energy per unit of time: 5e-4 in 2.5
    // for omega = 25, that of the second mode. Implicit Euler loses 7e-2 in 1.
    EXPECT_LT(run["energy_drift"], 5e-4);
}

TEST(RodRelease, DampedRodEndsAtTheEquilibrium) {
    // mu = 0.3 damps the slowest mode (frequency above 2) by exp(-0.3 * 2^2 / 2 * 40).
    const nlohmann::json run = release_json(
        {"40", "--dt", "0.05", "--integrator", "implicit-euler", "--damping", "0.3"});
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(run["tip"][c], run["equilibrium"]["tip"][c], 1e-6);
    }
    EXPECT_LE(run["largest_rise"], 1e-12);
}

TEST(RodRelease, WeightlessRodStaysAndHasNoDrift) {
    const nlohmann::json run = release_json({"1", "--dt", "0.1"}, "0");
    EXPECT_EQ(run["energy_drift"], nullptr);
    EXPECT_EQ(run["tip"], run["equilibrium"]["tip"]);
}

TEST(RodRelease, DivergenceOfTheSemiImplicitStepIsReported) {
    const nlohmann::json run =
        release_json({"3", "--dt", "0.1", "--integrator", "semi-implicit"}, "5000", 1);
    EXPECT_EQ(run["finished"], false);
    for (const nlohmann::json& s : run["energy"]) EXPECT_TRUE(s["total"].is_number());
}

TEST(RodRelease, PictureIsDrawn) {
    const TemporaryFolder folder;
    const std::string file = (folder / "rod.png").string();
    EXPECT_EQ(
        lancret({"rod", "--gamma", "3", "--release", "1", "--dt", "0.01", "-o", file})
            .exit_code,
        0);
    EXPECT_GT(read_bytes(file).size(), 5000u);
}

TEST(RodRelease, MisuseIsRejected) {
    EXPECT_THAT(lancret({"rod", "--release", "1"}), refuses_with("--dt"));
    EXPECT_THAT(lancret({"rod", "--dt", "1"}), refuses_with("--release"));
    EXPECT_THAT(lancret({"rod", "--damping", "1"}), refuses_with("--release"));
    EXPECT_THAT(lancret({"rod", "--release", "nan", "--dt", "1"}),
                refuses_with("--release"));
    EXPECT_THAT(lancret({"rod", "--release", "1", "--dt", "0"}), refuses_with("--dt"));
    EXPECT_THAT(lancret({"rod", "--release", "1e5", "--dt", "1e-9"}),
                refuses_with("--dt"));
    EXPECT_THAT(lancret({"rod", "--release", "1", "--dt", "1", "--integrator", "euler"}),
                refuses_with("--integrator"));
    EXPECT_THAT(lancret({"rod", "--release", "1", "--dt", "1", "--damping", "-1"}),
                refuses_with("--damping"));
}

}  // namespace
}  // namespace lancret
