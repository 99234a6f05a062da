// The example of docs/plugin.md compiles and runs.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/adapters/abi_groom.h"

namespace lancret {
namespace {

/// The first C block of the page; empty if there is none.
std::string example() {
    const std::string page =
        read_bytes(std::filesystem::path(LANCRET_SOURCE_DIR) / "docs" / "plugin.md");
    const std::string open = "```c\n";
    const std::size_t first = page.find(open);
    if (first == std::string::npos) return {};
    const std::size_t start = first + open.size();
    return page.substr(start, page.find("```", start) - start);
}

struct Compiled : TemporaryFolder {
    std::string source = (*this / "host.c").string();
    std::string program = (*this / "host").string();

    Compiled() { write_bytes(source, example()); }

    int compile() const {
        const std::string library = LANCRET_PLUGIN;
        const std::string folder = library.substr(0, library.rfind('/'));
        return std::system((std::string("'") + LANCRET_C_COMPILER +
                            "' " LANCRET_C_FLAGS
                            " -std=c89 -pedantic -Wall -Werror -I'" LANCRET_SOURCE_DIR
                            "' '" +
                            source + "' -o '" + program + "' '" + library +
                            "' -Wl,-rpath,'" + folder + "'")
                               .c_str());
    }
};

TEST(DocExample, CompilesAsC89) {
    ASSERT_NE(example().find("lancret_groom_expand_chunk"), std::string::npos);
    EXPECT_EQ(Compiled().compile(), 0);
}

TEST(DocExample, CountsThePointsOfAGroom) {
    const Compiled compiled;
    ASSERT_EQ(compiled.compile(), 0);
    const MadeGroom made;
    const AbiGroom groom(made.path);
    std::size_t points = 0;
    for (lancret_u32 i = 0; i < groom.info.chunks; ++i) {
        points +=
            groom.expand(i, options_at({}, LANCRET_BSPLINE)).positions[0].size() / 4;
    }
    FILE* pipe = popen(("'" + compiled.program + "' '" + made.path + "'").c_str(), "r");
    ASSERT_NE(pipe, nullptr);
    unsigned long printed = 0;
    EXPECT_EQ(std::fscanf(pipe, "%lu", &printed), 1);
    EXPECT_EQ(pclose(pipe), 0);
    EXPECT_EQ(printed, points);
}

TEST(DocExample, FailsForAMissingFile) {
    const Compiled compiled;
    ASSERT_EQ(compiled.compile(), 0);
    EXPECT_NE(std::system(("'" + compiled.program + "' none.toml > /dev/null").c_str()),
              0);
}

}  // namespace
}  // namespace lancret
