// Outputs that cannot be written are found out before the work; a run that fails leaves
// everything as it was.

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/tools/small_grooms.h"

namespace lancret {
namespace {

/// A command whose last option names a file to write.
struct Writer {
    std::vector<std::string> words;  ///< without the file's name
    std::string extension;
};

std::vector<Writer> writers(const SmallGrooms& folder) {
    return {
        {{"preview", folder.made, "-o"}, ".png"},
        {{"expand", folder.made, "-o"}, ".hair"},
        {{"fit", folder.made, "-o"}, ".h5"},
        {{"check", folder.made, "--json"}, ".json"},
        {{"preview", folder.made, "-o", folder.at("p.png"), "--stats"}, ".json"},
    };
}

CommandRun run_to(const Writer& writer, const std::string& file) {
    std::vector<std::string> words = writer.words;
    words.push_back(file);
    return lancret(words);
}

TEST(Output, IntoAMissingFolderIsRefused) {
    const SmallGrooms folder;
    const std::size_t files = folder.files();
    for (const Writer& writer : writers(folder)) {
        const std::string file = folder.at("none/out" + writer.extension);
        EXPECT_THAT(run_to(writer, file), refuses_with(file, "folder")) << file;
        EXPECT_EQ(folder.files(), files);
    }
}

TEST(Output, IntoAFolderWithoutWriteAccessIsRefused) {
    // Not even root can create a file in /proc.
    if (!std::filesystem::is_directory("/proc/self")) GTEST_SKIP() << "needs /proc";
    const SmallGrooms folder;
    const std::size_t files = folder.files();
    for (const Writer& writer : writers(folder)) {
        const std::string file = "/proc/out" + writer.extension;
        EXPECT_THAT(run_to(writer, file), refuses_with(file, "cannot be written"));
        EXPECT_EQ(folder.files(), files);
    }
}

TEST(Output, ThatIsAFolderIsRefused) {
    const SmallGrooms folder;
    std::filesystem::create_directory(folder / "taken.hair");
    const std::size_t files = folder.files();
    EXPECT_THAT(lancret({"expand", folder.made, "-o", folder.at("taken.hair")}),
                refuses_with("taken.hair", "folder"));
    EXPECT_EQ(folder.files(), files);
}

TEST(Output, OfAWrongExtensionIsRefusedWithTheRightOnes) {
    const SmallGrooms folder;
    const std::size_t files = folder.files();
    for (const char* name : {"out.jpg"}) {
        EXPECT_THAT(lancret({"preview", folder.made, "-o", folder.at(name)}),
                    refuses_with(name, ".exr", ".png"));
        EXPECT_THAT(lancret({"expand", folder.made, "-o", folder.at(name)}),
                    refuses_with(name, ".hair", ".txt"));
        EXPECT_THAT(lancret({"fit", folder.made, "-o", folder.at(name)}),
                    refuses_with(name, ".h5"));
    }
    EXPECT_EQ(folder.files(), files);
}

TEST(Output, InvalidOutputsOfAPictureAreRefusedBeforeRendering) {
    const SmallGrooms folder;
    const std::size_t files = folder.files();
    const std::string flat = folder.at("flat.exr");
    const auto run = [&](std::vector<std::string> more) {
        std::vector<std::string> words{"preview", folder.made, "-o", flat};
        words.insert(words.end(), more.begin(), more.end());
        return lancret(words);
    };
    EXPECT_THAT(run({"--deep", folder.at("deep.png")}), refuses_with("deep.png", ".exr"));
    EXPECT_THAT(run({"--deep", flat}), refuses_with("flat.exr", "two outputs"));
    EXPECT_THAT(run({"--deep", folder.at("none/deep.exr")}), refuses_with("deep.exr"));
    EXPECT_THAT(run({"--deep", folder.at("deep.exr"), "--progressive"}),
                refuses_with("--deep", "--progressive"));
    EXPECT_THAT(run({"--denoise", "--samples", "1"}),
                refuses_with("--denoise", "--samples 2"));
    EXPECT_EQ(folder.files(), files);
}

TEST(Output, IsUnchangedIfTheRunFails) {
    const SmallGrooms folder;
    const std::string groom = folder.file("bad.hair", "HAIR and nothing");
    const std::string old = "written by an earlier run";
    for (Writer& writer : writers(folder)) {
        const std::string out = folder.file("out" + writer.extension, old);
        writer.words[1] = groom;
        const std::size_t files = folder.files();
        EXPECT_THAT(run_to(writer, out), refuses_with("bad.hair"));
        EXPECT_EQ(read_bytes(out), old);
        EXPECT_EQ(folder.files(), files);
    }
}

TEST(Output, OverTheGroomItselfIsRefused) {
    const SmallGrooms folder;
    const std::string before = read_bytes(folder.hair);
    EXPECT_THAT(lancret({"expand", folder.hair, "--strands", "9", "-o", folder.hair}),
                refuses_with("lawn.hair"));
    EXPECT_EQ(read_bytes(folder.hair), before);
}

TEST(Output, CannotBeTheOtherOutput) {
    const SmallGrooms folder;
    const std::size_t files = folder.files();
    const std::string file = folder.at("both.json");
    EXPECT_THAT(lancret({"check", folder.made, "--json", file, "--stats", file}),
                refuses_with(file, "two outputs"));
    EXPECT_EQ(folder.files(), files);
}

TEST(Output, OfAFitNamesTheGroom) {
    // The groom sets 60 children on its scalp; without it the cache has 40 roots.
    const SmallGrooms folder;
    const std::string cache = folder.at("guides.h5");
    ASSERT_EQ(lancret({"fit", folder.made, "-o", cache}).exit_code, 0);
    const std::string stats = folder.at("stats.json");
    ASSERT_EQ(lancret({"expand", cache, "--stats", stats}).exit_code, 0);
    const nlohmann::json of_cache = nlohmann::json::parse(std::ifstream(stats));
    ASSERT_EQ(lancret({"expand", folder.made, "--stats", stats}).exit_code, 0);
    const nlohmann::json of_groom = nlohmann::json::parse(std::ifstream(stats));
    EXPECT_EQ(of_cache["strands"], of_groom["strands"]);
    EXPECT_NE(of_cache["strands"], of_cache["guides"]);
}

}  // namespace
}  // namespace lancret
