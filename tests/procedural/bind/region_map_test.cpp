#include "procedural/bind/region_map.h"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "guides/base/errors.h"
#include "tests/guides/base/temporary_folder.h"

namespace lancret {
namespace {

using testing::HasSubstr;

template <class Call>
std::string error_of(Call call) {
    try {
        call();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

void write_image(const std::filesystem::path& path, int width, int height, int channels,
                 const std::vector<std::uint8_t>& values) {
    const auto file = OIIO::ImageOutput::create(path.string());
    ASSERT_TRUE(file);
    ASSERT_TRUE(
        file->open(path.string(), {width, height, channels, OIIO::TypeDesc::UINT8}));
    ASSERT_TRUE(file->write_image(OIIO::TypeDesc::UINT8, values.data()));
    ASSERT_TRUE(file->close());
}

TEST(RegionMap, HasARegionForEachColour) {
    const TemporaryFolder folder;
    // Colours that differ by 1 of 255 in one channel are different.
    write_image(folder / "m.png", 3, 2, 3,
                {255, 0, 0, 0, 0, 255, 255, 0, 0,  //
                 254, 0, 0, 254, 0, 0, 0, 0, 255});
    const RegionMap map = read_region_map(folder / "m.png");
    EXPECT_EQ(map.width, 3);
    EXPECT_EQ(map.height, 2);
    EXPECT_EQ(map.count, 3u);
    EXPECT_EQ(map.regions, (std::vector<std::uint32_t>{0, 1, 0, 2, 2, 1}));
}

TEST(RegionMap, IsLookedUpAtTheNearestTexelWithVUpwards) {
    const RegionMap map{2, 2, {0, 1, 2, 3}, 4};
    EXPECT_EQ(region_at(map, {0.25, 0.75}), 0u);
    EXPECT_EQ(region_at(map, {0.51, 0.51}), 1u);
    EXPECT_EQ(region_at(map, {0.49, 0.49}), 2u);
    EXPECT_EQ(region_at(map, {0.75, 0.25}), 3u);
    // The edges belong to the map; beyond them it repeats.
    EXPECT_EQ(region_at(map, {0, 0}), 2u);
    EXPECT_EQ(region_at(map, {1, 1}), 1u);
    EXPECT_EQ(region_at(map, {1.25, -0.25}), 0u);
}

TEST(RegionMap, RejectsMoreThan4096Colours) {
    const TemporaryFolder folder;
    std::vector<std::uint8_t> noise;
    for (int i = 0; i < 5000; ++i) {
        for (const int c : {i % 256, i / 256, 7}) noise.push_back(std::uint8_t(c));
    }
    write_image(folder / "noise.png", 100, 50, 3, noise);
    EXPECT_THAT(error_of([&] { read_region_map(folder / "noise.png"); }),
                testing::AllOf(HasSubstr("noise.png: "), HasSubstr("4096")));
}

TEST(RegionMap, RejectsFilesThatAreNotImages) {
    const TemporaryFolder folder;
    EXPECT_THAT(error_of([&] { read_region_map(folder / "none.png"); }),
                HasSubstr("none.png: there is no such image"));
    EXPECT_THAT(error_of([&] { read_region_map(folder / "."); }),
                HasSubstr("there is no such image"));
    std::ofstream(folder / "text.png") << "not an image";
    EXPECT_THAT(error_of([&] { read_region_map(folder / "text.png"); }),
                HasSubstr("text.png: not a readable image"));
}

TEST(RegionIds, AreOnePerLine) {
    const TemporaryFolder folder;
    std::ofstream(folder / "ids.txt") << "# left, right\n3\n 0 \r\n\n4294967295 # last";
    EXPECT_EQ(read_region_ids(folder / "ids.txt", 3),
              (std::vector<std::uint32_t>{3, 0, 4294967295u}));
}

TEST(RegionIds, NameTheLineThatIsWrong) {
    const TemporaryFolder folder;
    const auto error = [&](const char* text) {
        std::ofstream(folder / "ids.txt") << text;
        return error_of([&] { read_region_ids(folder / "ids.txt", 3); });
    };
    EXPECT_THAT(error("1\n2\n-3\n"), HasSubstr("ids.txt:3: '-3'"));
    EXPECT_THAT(error("1\n2.5\n3\n"), HasSubstr("ids.txt:2: '2.5'"));
    EXPECT_THAT(error("1 2 3\n"), HasSubstr("ids.txt:1: '1 2 3'"));
    EXPECT_THAT(error("4294967296\n"), HasSubstr("ids.txt:1: "));
    EXPECT_THAT(error("1\n2\n"), HasSubstr("ids.txt:3: the file ends after 2"));
    EXPECT_THAT(error("1\n2\n3\n4\n"), HasSubstr("ids.txt:4: more regions than the 3"));
    EXPECT_THAT(error(""), HasSubstr("the file ends after 0"));
    EXPECT_THAT(error_of([&] { read_region_ids(folder / "none.txt", 3); }),
                HasSubstr("none.txt: cannot be opened"));
    EXPECT_THAT(error_of([&] { read_region_ids(folder / ".", 3); }),
                HasSubstr("cannot be opened"));
}

}  // namespace
}  // namespace lancret
