// Valid but unusual grooms: every strand passes the check, or the run reports what is
// wrong.

#include "tests/tools/small_grooms.h"

namespace lancret {
namespace {

/// Expects `lancret check` to pass for `groom` with these options.
void expect_pass(const std::string& groom, std::vector<std::string> options) {
    options.insert(options.begin(), {"check", groom});
    const CommandRun run = lancret(options);
    EXPECT_EQ(run.exit_code, 0) << groom << "\n" << run.out << run.err;
    EXPECT_THAT(run.out, testing::HasSubstr("\nPASS"));
    EXPECT_THAT(run.out, testing::Not(testing::HasSubstr("nan")));
}

struct OddGroom : testing::Test {
    SmallGrooms folder;

    /// The path of a file with these strands.
    std::string hair(const Strands& strands) const {
        write_hair(folder / "odd.hair", strands);
        return folder.at("odd.hair");
    }
};

TEST_F(OddGroom, OfOneStrandPasses) {
    const std::string one = hair(curled_lawn(1, 4, 5));
    expect_pass(one, {"--strands", "1"});
    expect_pass(one, {"--scalp", folder.obj, "--strands", "30"});
}

TEST_F(OddGroom, OfStraightStrandsOfTwoPointsPasses) {
    const std::vector<Vec3f> roots{{1, 1, 0}, {3, 1, 0}, {2, 3, 0}};
    expect_pass(hair(straight_hairs(roots, Vec3f(0, 0, 7))),
                {"--scalp", folder.obj, "--strands", "30"});
}

TEST_F(OddGroom, OfEqualStrandsPassesWithoutAScalpAndNamesTheDistanceWithOne) {
    Strands strands =
        straight_hairs(std::vector<Vec3f>(9, Vec3f(1, 1, 0)), Vec3f(1, 0, 4), 5);
    const std::string same = hair(strands);
    expect_pass(same, {"--strands", "9"});
    EXPECT_THAT(lancret({"check", same, "--scalp", folder.obj}),
                refuses_with("lawn.obj", "growth_distance"));
}

TEST_F(OddGroom, OfAMicrometreOrFarFromTheOriginPasses) {
    expect_pass(hair(curled_lawn(3, 1e-4f, 1e-4f)), {"--strands", "9"});
    // Floats are 64 apart here, so the hairs must be very long.
    const std::vector<Vec3f> roots{{9e8f, 9e8f, 9e8f}, {9.1e8f, 9e8f, 9e8f}};
    const std::string far = hair(straight_hairs(roots, Vec3f(0, 0, 6400), 5));
    const std::string png = folder.at("far.png");
    const CommandRun run = lancret(
        {"preview", far, "--strands", "2", "--size", "8x8", "--samples", "1", "-o", png});
    EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST_F(OddGroom, InMetresWithZUpIsReadInCentimetres) {
    write_hair(folder / "m.hair", curled_lawn(5, 0.04f, 0.05f));
    const std::string groom = folder.file(
        "m.toml",
        "[scene]\nup = 'Z'\nmetres_per_unit = 1\n[guides]\nfile = 'm.hair'\ncount = 3\n"
        "[scalp]\nfile = 'm.obj'\n[strands]\ncount = 40\nneighbours = 8\n");
    write_obj(folder / "m.obj", square_mesh(0.04f, 2));
    const std::string out = folder.at("c.hair");
    const CommandRun run = lancret({"expand", groom, "-o", out});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Strands strands = read_hair(out);
    ASSERT_EQ(strands.size(), 40u);
    // Hairs rise by 5 cm, of which the fit loses at most 2 %, on a square of 4 cm.
    for (std::size_t i = 0; i < strands.size(); ++i) {
        const auto points = strands.strand(i);
        EXPECT_NEAR(points.back().z() - points.front().z(), 5, 0.1);
        EXPECT_LE(points.front().head<2>().maxCoeff(), 4);
    }
    expect_pass(groom, {});
}

TEST_F(OddGroom, UsesAllStrandsIfMoreGuidesAreRequested) {
    const CommandRun run = lancret({"fit", folder.hair, "--guides", "1000"});
    EXPECT_THAT(run.out, testing::HasSubstr("25 guides of"));
}

TEST_F(OddGroom, OnAScalpWithTrianglesOfNoAreaPasses) {
    const std::string obj = folder.file(
        "zero.obj",
        "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nf 1 1 2\nf 1 2 3\nf 1 3 3\nf 1 3 4\n");
    expect_pass(folder.hair, {"--scalp", obj, "--strands", "50", "--guides", "1"});
}

TEST_F(OddGroom, OffItsScalpReportsHowFarRootsWereMoved) {
    const std::string obj = folder.file(
        "near.obj", "v 0 0 .5\nv 4 0 .5\nv 4 4 .5\nv 0 4 .5\nf 1 2 3\nf 1 3 4\n");
    const CommandRun run =
        lancret({"check", folder.hair, "--scalp", obj, "--strands", "50"});
    EXPECT_EQ(run.exit_code, 0) << run.out;
    EXPECT_THAT(run.err, testing::HasSubstr("25 of 25 guide roots"));
    EXPECT_THAT(run.err, testing::HasSubstr("0.500 cm"));
}

TEST_F(OddGroom, MuchLongerThanItsGuidesKeepsItsLength) {
    // Ten times the guides' length at the same curvature has ten times the turns.
    const std::string groom = folder.file(
        "long.toml",
        "[guides]\nfile = 'lawn.hair'\n[strands]\ncount = 25\nlength_scale = 10\n");
    expect_pass(groom, {});
}

}  // namespace
}  // namespace lancret
