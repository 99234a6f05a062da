// Invalid options: each is one line of error, exit code 2, and writes nothing.

#include "tests/tools/small_grooms.h"

namespace lancret {
namespace {

using testing::HasSubstr;

TEST(BadOption, WithoutSubcommandOrWithAnUnknownOneIsRefused) {
    EXPECT_THAT(lancret({}), refuses_with("subcommand", "--help"));
    EXPECT_THAT(lancret({"chek"}), refuses_with("'chek'", "'check'", "--help"));
}

TEST(BadOption, UnknownOptionIsNamed) {
    const SmallGrooms folder;
    for (const char* command : {"expand", "info"}) {
        EXPECT_THAT(lancret({command, folder.hair, "--colour"}),
                    refuses_with("--colour", "--help"));
    }
}

TEST(BadOption, MissingFileArgumentIsNamed) {
    for (const char* command : {"preview", "info"}) {
        EXPECT_THAT(lancret({command}), refuses_with("required", "--help")) << command;
    }
}

TEST(BadOption, ValueOutOfRangeIsNamedWithItsOption) {
    const SmallGrooms folder;
    const auto expect_error = [&](const char* option, const char* value) {
        EXPECT_THAT(lancret({"expand", folder.made, option, value}), refuses_with(option))
            << value;
    };
    for (const char* count : {"0", "1e5"}) expect_error("--strands", count);
    for (const char* count : {"0"}) expect_error("--segments", count);
    for (const char* seed : {"-1", "18446744073709551616"}) expect_error("--seed", seed);
    for (const char* count : {"0", "5 %", "nan%", ""}) expect_error("--guides", count);
    expect_error("--basis", "bezier");
}

TEST(BadOption, GuideOptionsAreRefusedForAGuideCache) {
    const SmallGrooms folder;
    const std::string cache = folder.at("g.h5");
    ASSERT_EQ(lancret({"fit", folder.hair, "--guides", "4", "-o", cache}).exit_code, 0);
    EXPECT_THAT(lancret({"check", cache, "--guides", "2", "--strands", "4"}),
                refuses_with("--guides", "g.h5"));
    EXPECT_THAT(lancret({"check", cache, "--segments", "2", "--strands", "4"}),
                refuses_with("--segments", "g.h5"));
}

TEST(BadOption, UnknownBlendIsNamedWithTheKnownOnes) {
    const SmallGrooms folder;
    EXPECT_THAT(lancret({"expand", folder.made, "--blend", "mean"}),
                refuses_with("--blend", "mean", "option1", "position"));
}

TEST(BadOption, InvalidSizeIsNamed) {
    const SmallGrooms folder;
    for (const char* size : {"64x64x3", "64 x 64", "4294967297x1", ""}) {
        EXPECT_THAT(
            lancret({"preview", folder.made, "-o", folder.at("a.png"), "--size", size}),
            refuses_with("--size"))
            << size;
    }
    EXPECT_THAT(
        lancret({"preview", folder.made, "-o", folder.at("a.png"), "--samples", "0"}),
        refuses_with("--samples"));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

TEST(BadOption, MorePointsThanAnIndexCanHoldAreRefusedAtOnce) {
    const SmallGrooms folder;
    EXPECT_THAT(
        lancret({"expand", folder.made, "--strands", "100000000", "--intervals", "1000"}),
        refuses_with("--strands", "--intervals"));
}

TEST(BadOption, NegativeToleranceIsNamed) {
    const SmallGrooms folder;
    EXPECT_THAT(lancret({"check", folder.made, "--length", "-1"}),
                refuses_with("--length"));
    EXPECT_THAT(lancret({"check", folder.made, "--length", "nan"}),
                refuses_with("--length"));
}

TEST(Help, OfEverySubcommandHasExamples) {
    for (const char* command : {"preview", "expand", "check", "fit", "info"}) {
        const CommandRun run = lancret({command, "--help"});
        EXPECT_EQ(run.exit_code, 0);
        EXPECT_THAT(run.out, HasSubstr("Examples:\n  lancret " + std::string(command)));
        EXPECT_EQ(run.err, "");
    }
    const CommandRun run = lancret({"--help"});
    EXPECT_EQ(run.exit_code, 0);
    for (const char* command : {"preview", "expand", "check", "fit", "info"}) {
        EXPECT_THAT(run.out, HasSubstr(command));
    }
}

}  // namespace
}  // namespace lancret
