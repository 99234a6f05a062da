// Invalid grooms in TOML: each error is one line with the file and its line number.

#include "tests/tools/small_grooms.h"

namespace lancret {
namespace {

/// `lancret info` on a groom with this text.
CommandRun info_of(const SmallGrooms& folder, std::string_view text) {
    return lancret({"info", folder.file("g.toml", text)});
}

TEST(BadGroom, TypingErrorInAKeyIsNamedWithTheNearestKey) {
    const SmallGrooms folder;
    EXPECT_THAT(info_of(folder, "[guides]\n\nsegmets = 8\n"),
                refuses_with("g.toml:3: ", "segmets", "segments", "[guides]"));
    EXPECT_THAT(info_of(folder, "[guides.made]\ncurl_radios = 1\n"),
                refuses_with("g.toml:2: ", "curl_radios", "curl_radius"));
}

TEST(BadGroom, TypingErrorInATableIsNamedWithTheNearestTable) {
    const SmallGrooms folder;
    EXPECT_THAT(info_of(folder, "[guidse]\nsegments = 8\n"),
                refuses_with("g.toml:1: ", "guidse", "guides"));
    EXPECT_THAT(info_of(folder, "[guides]\n[guides.maid]\nstrands = 8\n"),
                refuses_with("g.toml:2: ", "maid", "made"));
}

TEST(BadGroom, WrongTypeIsNamedWithItsLine) {
    const SmallGrooms folder;
    const auto expect_error = [&](const char* text, const char* key) {
        EXPECT_THAT(info_of(folder, text), refuses_with("g.toml:2: ", key)) << text;
    };
    expect_error("[guides]\nsegments = 8.5\n", "segments");
    expect_error("[guides]\nfile = 3\n", "file");
    expect_error("[scene]\ngravity = [0, 1, nan]\n", "gravity");
    expect_error("[guides]\nmade = 3\n", "made");
    EXPECT_THAT(info_of(folder, "strands = 100\n"),
                refuses_with("g.toml:1: ", "strands"));
}

TEST(BadGroom, ValueOutOfRangeIsNamedWithTheRange) {
    const SmallGrooms folder;
    const auto expect_error = [&](const char* text, const char* key, const char* range) {
        EXPECT_THAT(info_of(folder, text), refuses_with("g.toml:2: ", key, range))
            << text;
    };
    expect_error("[guides]\nsegments = 0\n", "segments", "1 and 200");
    expect_error("[strands]\ncount = 0\n", "count", "between 1 and");
    expect_error("[scene]\nmetres_per_unit = 0\n", "metres_per_unit", "between");
    expect_error("[material]\ncolour = [0, 2, 0]\n", "colour", "0 to 1");
    expect_error("[camera]\nview = [0, 0, 0]\n", "view", "zero");
    expect_error("[camera]\nposition = [0, 1e30, 0]\n", "position", "1e+09");
}

TEST(BadGroom, InvalidPartingsAreNamedWithTheirLine) {
    const SmallGrooms folder;
    const auto expect_error = [&](const char* text, const char* what) {
        EXPECT_THAT(info_of(folder, text), refuses_with("g.toml:2: ", what)) << text;
    };
    expect_error("[[partings]]\npoints = [[0, 0, 0]]\n", "2 or more");
    expect_error("[[partings]]\npoints = [[0, 0, 0], [0, 1]]\n", "item 2");
    expect_error("[[partings]]\npoints = [[0, 0, 0], [0, nan, 1]]\n", "item 2");
    expect_error("[[partings]]\npoints = [[0, 0, 0], [0, 1e30, 1]]\n", "1e+09");
    EXPECT_THAT(info_of(folder, "[[partings]]\npoint = [[0, 0, 0], [0, 1, 1]]\n"),
                refuses_with("g.toml:1: ", "points"));
    expect_error("\npartings = 3\n", "[[partings]]");
}

TEST(BadGroom, RegionsFromTwoPlacesOrNoneAreRefused) {
    const SmallGrooms folder;
    EXPECT_THAT(info_of(folder, "[regions]\ntexture = 'a.png'\nids = 'a.txt'\n"),
                refuses_with("g.toml:3: ", "texture", "ids"));
    EXPECT_THAT(info_of(folder, "[regions]\ntextur = 'a.png'\n"),
                refuses_with("g.toml:2: ", "textur", "texture"));
    folder.file("ids.txt", "1\n2\n");
    const std::string groom =
        folder.file("g.toml",
                    "[guides]\nsegments = 2\n[guides.made]\nstrands = 3\n"
                    "[strands]\ncount = 3\n[regions]\nids = 'ids.txt'\n");
    EXPECT_THAT(lancret({"check", groom}), refuses_with("ids.txt:3: ", "3 strands"));
}

TEST(BadGroom, InvalidLimitsOfGuidesAreNamedWithTheRange) {
    const SmallGrooms folder;
    EXPECT_THAT(info_of(folder, "[strands]\nmax_distance = 0\n"),
                refuses_with("g.toml:2: ", "max_distance", "between"));
    EXPECT_THAT(info_of(folder, "[strands]\nmax_angle_degrees = 200\n"),
                refuses_with("g.toml:2: ", "max_angle_degrees", "180"));
}

TEST(BadGroom, UnknownChoiceIsNamedWithTheChoices) {
    const SmallGrooms folder;
    EXPECT_THAT(info_of(folder, "[strands]\nblend = 'optoin1'\n"),
                refuses_with("g.toml:2: ", "optoin1", "option1", "position"));
    EXPECT_THAT(info_of(folder, "[guides]\nbasis = 'bezier'\n"),
                refuses_with("g.toml:2: ", "bezier", "catmull-rom"));
}

TEST(BadGroom, ContradictionsAreRefused) {
    const SmallGrooms folder;
    EXPECT_THAT(
        info_of(folder, "[guides]\nfile = 'a.hair'\n[guides.made]\nstrands = 3\n"),
        refuses_with("g.toml:3: ", "file", "made"));
    EXPECT_THAT(info_of(folder, "[guides]\ncount = 3\nshare = 0.5\n"),
                refuses_with("g.toml:3: ", "count", "share"));
    EXPECT_THAT(info_of(folder, "[guides.made]\nshortest = 30\nlongest = 20\n"),
                refuses_with("g.toml:2: ", "shortest", "longest"));
    EXPECT_THAT(info_of(folder, "[light]\nsky = [1, 1, 1]\nenvironment = 'e.exr'\n"),
                refuses_with("g.toml:2: ", "sky", "environment"));
    EXPECT_THAT(info_of(folder, "[camera]\nposition = [1, 1, 1]\nview = [1, 0, 0]\n"),
                refuses_with("g.toml:3: ", "position", "view"));
    EXPECT_THAT(info_of(folder, "[camera]\nposition = [1, 1, 1]\ntarget = [1, 1, 1]\n"),
                refuses_with("g.toml:3: ", "target", "position"));
}

TEST(BadGroom, InvalidTomlIsRefusedWithItsLine) {
    const SmallGrooms folder;
    EXPECT_THAT(info_of(folder, "[guides\n"), refuses_with("g.toml:1: "));
    EXPECT_THAT(info_of(folder, read_bytes(folder.hair)), refuses_with("g.toml:1: "));
    EXPECT_THAT(info_of(folder, read_bytes(LANCRET_COMMAND).substr(0, 65536)),
                refuses_with("g.toml:1: "));
}

TEST(BadGroom, DeepNestingIsRefused) {
    const SmallGrooms folder;
    EXPECT_THAT(info_of(folder, "x = " + std::string(1'000'000, '[')),
                refuses_with("g.toml:1: "));
}

TEST(BadGroom, PictureThatCannotBeReadIsRefusedByName) {
    const SmallGrooms folder;
    const std::string broken = folder.file("broken.png", "\x89PNG\r\n\x1a\n nothing");
    for (const char* table : {"[material]\nscalp_texture", "[light]\nenvironment"}) {
        for (const char* name : {"none.png", "broken.png"}) {
            const CommandRun run =
                info_of(folder, std::string(table) + " = '" + name + "'\n");
            EXPECT_THAT(run, refuses_with(folder.at(name))) << table;
        }
    }
}

TEST(BadGroom, PathsStartFromTheFolderOfTheGroom) {
    const SmallGrooms folder;
    const std::string groom = folder.file("g.toml", "[guides]\nfile = 'none.hair'\n");
    EXPECT_THAT(lancret({"expand", groom}), refuses_with(folder.at("none.hair")));
    const std::string odd = folder.file("odd.toml", "[guides]\nfile = 'lawn.obj'\n");
    EXPECT_THAT(lancret({"expand", odd}), refuses_with("lawn.obj"));
}

TEST(BadGroom, UnitsThatScaleHairBeyondTheLimitAreRefused) {
    const SmallGrooms folder;
    const std::string groom = folder.file(
        "g.toml", "[scene]\nmetres_per_unit = 1e6\n[guides]\nfile = 'away.hair'\n");
    const Strands away = straight_hairs({Vec3f(1e6f, 0, 0)}, Vec3f(0, 1, 0), 8);
    write_hair(folder / "away.hair", away);
    EXPECT_THAT(lancret({"expand", groom, "--strands", "1"}),
                refuses_with("away.hair", "metres_per_unit"));
}

}  // namespace
}  // namespace lancret
