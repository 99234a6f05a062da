#include "procedural/groom/groom_source.h"

#include <gmock/gmock.h>

#include "tests/guides/base/temporary_folder.h"

namespace lancret {
namespace {

GroomSettings groom_of(const std::string& text, std::vector<GroomParameter> parameters) {
    GroomSource source;
    source.text = text;
    source.parameters = std::move(parameters);
    return read_groom_source(source).groom;
}

TEST(GroomParameters, OverrideTheFile) {
    const std::string text =
        "[guides]\ncount = 7\n[strands]\ncount = 10\nblend = 'bishop'\nadapt = true\n";
    const GroomSettings groom = groom_of(text, {{"strands.count", std::nullopt, 20},
                                                {"strands.blend", "position", 0},
                                                {"strands.adapt", std::nullopt, 0}});
    EXPECT_EQ(groom.strands, 20u);
    EXPECT_EQ(groom.expand.blend, Blend::position);
    EXPECT_FALSE(groom.adapt);
    EXPECT_EQ(groom.guides.number, 7u);
}

TEST(GroomParameters, GuideCountAndShareReplaceEachOther) {
    const GuideCount share =
        groom_of("[guides]\ncount = 7\n", {{"guides.share", std::nullopt, 0.5}}).guides;
    EXPECT_EQ(share.number, std::nullopt);
    EXPECT_EQ(share.share, 0.5);
    const GuideCount number =
        groom_of("[guides]\nshare = 0.5\n", {{"guides.count", std::nullopt, 9}}).guides;
    EXPECT_EQ(number.number, 9u);
    EXPECT_EQ(number.share, std::nullopt);
    EXPECT_THAT(input_error([] {
                    groom_of("", {{"guides.count", std::nullopt, 9},
                                  {"guides.share", std::nullopt, 0.5}});
                }),
                testing::HasSubstr("not both"));
}

TEST(GroomParameters, SeedsMayBeTextsBecauseDoublesCannotHoldAll) {
    const auto seed = [](GroomParameter parameter) {
        parameter.name = "strands.seed";
        return groom_of("[strands]\nseed = 5\n", {parameter}).seed;
    };
    EXPECT_EQ(seed({"", "18446744073709551615", 0}), 18446744073709551615u);
    EXPECT_EQ(seed({"", "9007199254740993", 0}), 9007199254740993u);
    EXPECT_EQ(seed({"", std::nullopt, 6}), 6u);
    for (const char* text : {"", "-1", "1e3", "18446744073709551616", "7 "}) {
        EXPECT_THAT(input_error([&] {
                        seed({"", text, 0});
                    }),
                    testing::HasSubstr("'seed' must be a whole number"));
    }
    // A text in the file is not a seed.
    EXPECT_THAT(input_error([] { groom_of("[strands]\nseed = '5'\n", {}); }),
                testing::HasSubstr("'seed' must be a whole number"));
}

TEST(GroomSource, LeavesTablesOfItsCallerToTheCaller) {
    GroomSource source;
    source.text = "[strands]\ncount = 10\n[camera]\nmargin = 2\n";
    const SourcedGroom unread = read_groom_source(source);
    EXPECT_THAT(input_error([&] { unread.toml.finish(); }),
                testing::HasSubstr("unknown key 'camera'"));
    const SourcedGroom read = read_groom_source(source);
    EXPECT_EQ(read.toml.table("camera").number("margin"), 2.0);
    read.toml.finish();
    EXPECT_EQ(read.text, *source.text);
}

}  // namespace
}  // namespace lancret
