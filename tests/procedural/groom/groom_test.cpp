#include "procedural/groom/groom.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/guides/base/temporary_folder.h"

namespace lancret {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

GroomSettings groom_of(std::string_view text) {
    const TomlTable table = TomlTable::from_text(text, "g.toml");
    GroomSettings groom = read_groom(table, "g.toml");
    table.finish();
    return groom;
}

std::string error_of(std::string_view text) {
    return input_error([&] { groom_of(text); });
}

TEST(Groom, AnEmptyFileIsTheGeneratedGroom) {
    const GroomSettings groom = groom_of("");
    EXPECT_EQ(groom.name, "g.toml");
    EXPECT_TRUE(groom.strands_file.empty());
    EXPECT_EQ(groom.strands, std::nullopt);
    EXPECT_EQ(child_count(groom, true, 123), 50000u);
    EXPECT_EQ(child_count(groom, false, 123), 123u);
    EXPECT_EQ(groom.expand.blend, Blend::detail);
    EXPECT_EQ(groom.scene.up, Vec3::UnitY());
    EXPECT_EQ(groom.scene.gravity, Vec3(0, -981, 0));
    EXPECT_DOUBLE_EQ(groom.scene.centimetres_per_unit(), 1);
}

TEST(Groom, ReadsEveryKey) {
    const GroomSettings groom = groom_of(R"(
[scene]
up = "Z"
metres_per_unit = 1
[guides]
file = "hair/long.hair"
basis = "bspline"
count = 120
segments = 12
fit_root_frame = false
[scalp]
file = "/head.obj"
growth_distance = 0.75
[strands]
count = 1234
seed = 9
blend = "position"
neighbours = 3
exponent = 1.5
length_scale = 0.5
tolerance = 0.02
intervals = 36
curve = "hermite"
shape = "round"
[width]
root = 0.01
tip = 0.002
)");
    EXPECT_EQ(groom.scene.up, Vec3::UnitZ());
    EXPECT_EQ(groom.scene.gravity, Vec3(0, 0, -981));
    EXPECT_DOUBLE_EQ(groom.scene.centimetres_per_unit(), 100);
    EXPECT_EQ(groom.strands_file.filename(), "long.hair");
    EXPECT_EQ(groom.basis, Basis::bspline);
    EXPECT_EQ(groom.guides.number, 120u);
    EXPECT_EQ(groom.fit.segments, 12);
    EXPECT_FALSE(groom.fit.fit_root_frame);
    EXPECT_EQ(groom.scalp_file, "/head.obj");
    EXPECT_EQ(groom.growth_distance, 0.75);
    EXPECT_EQ(groom.strands, 1234u);
    EXPECT_EQ(groom.seed, 9u);
    EXPECT_EQ(groom.expand.blend, Blend::position);
    EXPECT_EQ(groom.bind.neighbours, 3);
    EXPECT_EQ(groom.bind.exponent, 1.5);
    EXPECT_EQ(groom.bind.length_scale, 0.5f);
    EXPECT_EQ(groom.tolerance, 0.02);
    EXPECT_EQ(groom.intervals, 36);
    EXPECT_EQ(groom.expand.basis, CurveBasis::hermite);
    EXPECT_EQ(groom.expand.shape, CurveShape::round);
    // The file has widths, curves have radii.
    EXPECT_FLOAT_EQ(groom.expand.taper.root, 0.005f);
    EXPECT_FLOAT_EQ(groom.expand.taper.tip, 0.001f);
}

TEST(Groom, ReadsTheGeneratedGroom) {
    const GroomSettings groom = groom_of(
        "[guides.made]\nstrands = 77\nseed = 5\nshortest = 10\nlongest = 12\n"
        "curl_radius = 0.2\ncurl_wavelength = 3\nfrizz = 0\n");
    EXPECT_EQ(groom.made.strands, 77);
    EXPECT_EQ(groom.made.seed, 5u);
    EXPECT_EQ(groom.made.shortest, 10);
    EXPECT_EQ(groom.made.longest, 12);
    EXPECT_EQ(groom.made.curl_radius, 0.2);
    EXPECT_EQ(groom.made.curl_wavelength, 3);
    EXPECT_EQ(groom.made.frizz, 0);
}

TEST(Groom, PathsAreRelativeToItsFolder) {
    TemporaryFolder folder;
    write_bytes(folder / "a.toml", "[guides]\nfile = \"b/c.hair\"\n");
    const GroomSettings groom = read_groom(TomlTable::from_file(folder / "a.toml"), "a");
    EXPECT_EQ(groom.strands_file.lexically_normal(), folder / "b/c.hair");
}

TEST(Groom, GravityInTheFileReplacesTheDefault) {
    const GroomSettings groom = groom_of("[scene]\nup = \"Z\"\ngravity = [0, 1, -2]\n");
    EXPECT_EQ(groom.scene.gravity, Vec3(0, 1, -2));
}

TEST(Groom, ErrorsNameTheLineAndTheNearestKey) {
    EXPECT_EQ(error_of("[strands]\ncount = 10\nneighbors = 3\n"),
              "g.toml:3: unknown key 'neighbors' in [strands], did you mean "
              "'neighbours'?");
    EXPECT_EQ(error_of("[widths]\nroot = 1\n"),
              "g.toml:1: unknown key 'widths', did you mean 'width'?");
    EXPECT_THAT(error_of("[strands]\nblend = \"option4\"\n"),
                StartsWith("g.toml:2: unknown blend 'option4', did you mean "));
    EXPECT_THAT(error_of("\n[scene]\nup = \"y\"\n"), StartsWith("g.toml:3: "));
}

TEST(Groom, ErrorsNameTheRange) {
    EXPECT_THAT(error_of("[strands]\nneighbours = 9\n"), HasSubstr("between 1 and 8"));
    for (const char* text :
         {"[strands]\ncount = 0\n", "[strands]\ncount = -5\n",
          "[strands]\ntolerance = 0\n", "[strands]\nlength_scale = nan\n",
          "[strands]\ncount = 1e3\n", "[guides]\nsegments = 0\n",
          "[guides]\nshare = 1.5\n", "[scene]\nmetres_per_unit = 0\n",
          "[width]\nroot = -1\n", "[scalp]\ngrowth_distance = 0\n"}) {
        EXPECT_THAT(error_of(text), StartsWith("g.toml:2: ")) << text;
    }
}

TEST(Groom, ContradictionsAreErrors) {
    EXPECT_THAT(error_of("[guides]\ncount = 5\nshare = 0.1\n"),
                StartsWith("g.toml:3: set either 'count' or 'share'"));
    EXPECT_THAT(error_of("[guides]\nfile = \"a.hair\"\n[guides.made]\nstrands = 4\n"),
                HasSubstr("set either 'file' or [guides.made]"));
}

TEST(GuideCount, ReadsNumbersAndPercentages) {
    EXPECT_EQ(parse_guide_count("400", "x").number, 400u);
    EXPECT_EQ(parse_guide_count("400", "x").share, std::nullopt);
    EXPECT_DOUBLE_EQ(*parse_guide_count("5%", "x").share, 0.05);
    EXPECT_DOUBLE_EQ(*parse_guide_count("0.5%", "x").share, 0.005);
    EXPECT_DOUBLE_EQ(*parse_guide_count("100%", "x").share, 1);
}

TEST(GuideCount, RejectsEverythingElse) {
    for (const char* text : {"", "0", "-3", "3.5", "abc", "5 %", "%", "0%", "-1%", "101%",
                             "nan", "nan%", "inf", "1e300", "5%%", "7 guides"}) {
        EXPECT_THAT(
            input_error([&] { parse_guide_count(text, "--guides"); }),
            StartsWith("--guides: invalid number of guides '" + std::string(text) + "'"))
            << text;
    }
}

TEST(GuideCount, IsAtMostTheNumberOfStrands) {
    EXPECT_EQ(GuideCount{}.of(100), 100u);
    EXPECT_EQ(GuideCount{}.of(10000), 500u);
    EXPECT_EQ((GuideCount{.number = 50, .share = {}}.of(20)), 20u);
    EXPECT_EQ((GuideCount{.number = {}, .share = 0.05}.of(1000)), 50u);
    EXPECT_EQ((GuideCount{.number = {}, .share = 0.001}.of(100)), 1u);
    EXPECT_EQ((GuideCount{.number = {}, .share = 1.0}.of(33)), 33u);
}

TEST(Groom, RibbonsMustBeBSplines) {
    const GroomSettings lawn =
        groom_of("[guides.made]\nkind = 'lawn'\n[strands]\nshape = 'ribbon'\n");
    EXPECT_EQ(lawn.made.kind, MadeKind::lawn);
    EXPECT_EQ(lawn.expand.shape, CurveShape::ribbon);
    const std::string error =
        error_of("[strands]\nshape = 'ribbon'\ncurve = 'hermite'\n");
    EXPECT_THAT(error, StartsWith("g.toml:2:"));
    EXPECT_THAT(error, HasSubstr("bspline"));
}

}  // namespace
}  // namespace lancret
