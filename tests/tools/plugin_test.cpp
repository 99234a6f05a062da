// A preview takes its strands only from the loaded library.

#include <nlohmann/json.hpp>
#include <set>

#include "render_test/image/image.h"
#include "tests/tools/small_grooms.h"
#include "tests/tools/view_layers.h"

namespace lancret {
namespace {

using testing::HasSubstr;

/// Sets an environment variable during its lifetime.
class Variable {
  public:
    Variable(const char* name, const std::string& value) : name_(name) {
        setenv(name, value.c_str(), 1);
    }
    ~Variable() { unsetenv(name_); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    const char* name_;
};

std::vector<std::string> words_of(const SmallGrooms& folder) {
    return {"preview", folder.made,       "--strands", "3",
            "--size",  "60x60",           "--samples", "1",
            "--view",  "curvature",       "--stats",   folder.at("a.json"),
            "-o",      folder.at("a.exr")};
}

TEST(PreviewPlugin, PicturesShowOnlyTheStrandsOfTheLibrary) {
    const SmallGrooms folder;
    const Variable other("LANCRET_LIBRARY", OTHER_PLUGIN);
    const CommandRun run = lancret(words_of(folder));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("largest 0.75, strand 1002"));
    const auto stats = nlohmann::json::parse(read_bytes(folder.at("a.json")));
    EXPECT_EQ(stats["strands"], 3);
    EXPECT_EQ(stats["points"], 15);
    EXPECT_EQ(stats["classes"][0]["intervals"], 2);
    const Layers layers = read_layers(folder.at("a.exr"));
    std::set<std::uint32_t> seen(layers.id.begin(), layers.id.end());
    seen.erase(kNothingId);
    EXPECT_EQ(seen, (std::set<std::uint32_t>{1000, 1001, 1002}));
    // Three posts of 1 x 10 cm in a picture that frames 5 x 10 cm with a margin of 1.15,
    // seen slightly from the side and above: about 3 x 1 / 5 of its middle.
    std::size_t covered = 0;
    for (std::size_t i = 0; i < layers.id.size(); ++i) {
        if (layers.id[i] == kNothingId) continue;
        ++covered;
        EXPECT_EQ(layers.value[i], 0.25f * float(layers.id[i] - 999));
    }
    EXPECT_GT(covered, 200u);
    EXPECT_LT(covered, 1800u);
}

TEST(PreviewPlugin, OfSeveralChunksThatFailAtOnceOneIsReported) {
    const SmallGrooms folder;
    const Variable other("LANCRET_LIBRARY", OTHER_PLUGIN);
    const Variable fails("OTHER_PLUGIN_FAILS", "1");
    for (int run = 0; run < 20; ++run) {
        EXPECT_THAT(lancret(words_of(folder)), refuses_with("the posts are gone"));
    }
}

TEST(PreviewPlugin, OtherLibrariesAreRefused) {
    const SmallGrooms folder;
    {
        const Variable none("LANCRET_LIBRARY", folder.at("none.so"));
        EXPECT_THAT(lancret(words_of(folder)),
                    refuses_with(folder.at("none.so"), "cannot be loaded"));
    }
    {
        const Variable maths("LANCRET_LIBRARY", "libm.so.6");
        EXPECT_THAT(lancret(words_of(folder)),
                    refuses_with("libm.so.6: has no function lancret_abi_version"));
    }
    const Variable other("LANCRET_LIBRARY", OTHER_PLUGIN);
    const Variable version("OTHER_PLUGIN_VERSION", "99");
    EXPECT_THAT(lancret(words_of(folder)),
                refuses_with("has version 99 of the interface, expected 2"));
}

}  // namespace
}  // namespace lancret
