#include "guides/files/mitsuba_file.h"

#include <gmock/gmock.h>

#include <cstring>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "tests/guides/base/temporary_folder.h"

namespace lancret {
namespace {

/// As Mitsuba reads it: a blank line ends a strand.
std::vector<std::vector<Point4f>> parse(const std::string& text) {
    std::vector<std::vector<Point4f>> strands;
    std::istringstream lines(text);
    bool fresh = true;
    for (std::string line; std::getline(lines, line);) {
        if (line.empty()) {
            fresh = true;
            continue;
        }
        if (fresh) strands.emplace_back();
        fresh = false;
        Point4f p{};
        char* at = line.data();
        for (float* x : {&p.x, &p.y, &p.z, &p.w}) *x = std::strtof(at, &at);
        EXPECT_EQ(*at, '\0');
        strands.back().push_back(p);
    }
    return strands;
}

TEST(MitsubaFile, ReadsBackAsTheSameFloats) {
    std::mt19937 random(1);
    std::vector<Point4f> points(5 * 7);
    for (Point4f& p : points) {
        for (float* x : {&p.x, &p.y, &p.z, &p.w}) {
            *x = std::ldexp(float(random()), int(random() % 60) - 60);
        }
    }
    points[3] = {-0.0f, std::numeric_limits<float>::max(),
                 std::numeric_limits<float>::denorm_min(), 0.1f};
    const TemporaryFolder folder;
    write_mitsuba(folder / "a.txt", points, 7);
    const auto strands = parse(read_bytes(folder / "a.txt"));
    ASSERT_EQ(strands.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) {
        ASSERT_EQ(strands[i].size(), 7u);
        EXPECT_EQ(
            std::memcmp(strands[i].data(), points.data() + 7 * i, 7 * sizeof(Point4f)),
            0);
    }
}

TEST(MitsubaFile, PutsABlankLineBetweenStrands) {
    const TemporaryFolder folder;
    const std::vector<Point4f> points(8, Point4f{1, 2, 0.5f, 0.25f});
    write_mitsuba(folder / "a.txt", points, 4);
    const std::string strand = "1 2 0.5 0.25\n1 2 0.5 0.25\n1 2 0.5 0.25\n1 2 0.5 0.25\n";
    EXPECT_EQ(read_bytes(folder / "a.txt"), strand + "\n" + strand);
}

TEST(MitsubaFile, RejectsPartialStrandsAndInvalidNumbers) {
    const TemporaryFolder folder;
    std::vector<Point4f> points(8, Point4f{});
    EXPECT_THROW(write_mitsuba(folder / "a.txt", points, 3), std::invalid_argument);
    EXPECT_THROW(write_mitsuba(folder / "a.txt", points, 5), std::invalid_argument);
    EXPECT_THROW(write_mitsuba(folder / "a.txt", {}, 4), std::invalid_argument);
    points[6].w = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(input_error([&] { write_mitsuba(folder / "a.txt", points, 4); }),
                testing::HasSubstr("a.txt: strand 1, point 2 is not finite"));
    EXPECT_EQ(folder.files(), 0u);
}

}  // namespace
}  // namespace lancret
