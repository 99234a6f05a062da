#include "guides/files/hair_file.h"
#include "guides/files/hair_file_write.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstring>
#include <limits>
#include <random>
#include <stdexcept>

#include "tests/guides/base/temporary_folder.h"

namespace lancret {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

template <class T>
std::string bytes_of(const T& value) {
    return {reinterpret_cast<const char*>(&value), sizeof value};
}

template <class T>
void set(std::string& bytes, std::size_t at, T value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
}

/// A file assembled by hand, without the writer: strands of 2, 1 and 3 points.
struct Handmade {
    std::string header = std::string(128, '\0');
    std::string segments, arrays;

    explicit Handmade(std::uint32_t flags = 3) {
        std::memcpy(header.data(), "HAIR", 4);
        set<std::uint32_t>(header, 4, 3);
        set<std::uint32_t>(header, 8, 6);
        set<std::uint32_t>(header, 12, flags);
        set<float>(header, 20, 0.01f);
        set<float>(header, 28, 0.25f);
        std::memcpy(header.data() + 40, "by hand", 7);
        for (std::uint16_t s : {1, 0, 2}) segments += bytes_of(s);
        for (int i = 0; i < 18; ++i) arrays += bytes_of(float(i));
    }
    std::string bytes() const { return header + segments + arrays; }
};

struct HairFile : testing::Test {
    TemporaryFolder folder;
    HairReport report;

    Strands read(std::string_view bytes) {
        write_bytes(folder / "a.hair", bytes);
        return read_hair(folder / "a.hair", &report);
    }
    std::string error_of(std::string_view bytes) {
        return input_error([&] { read(bytes); });
    }
};

Strands random_strands(unsigned seed, bool attributes) {
    std::mt19937 random(seed);
    std::normal_distribution<float> normal;
    Strands strands;
    for (int i = 0; i < 20; ++i) {
        strands.first.push_back(strands.first.back() + 2 + random() % 9);
    }
    for (std::uint32_t i = 0; i < strands.first.back(); ++i) {
        strands.points.push_back({normal(random), normal(random), normal(random)});
        if (!attributes) continue;
        strands.thickness.push_back(std::abs(normal(random)));
        strands.transparency.push_back(normal(random));
        strands.colours.push_back({normal(random), normal(random), normal(random)});
        strands.uvs.push_back({normal(random), normal(random)});
    }
    // Values that a copy through text or a comparison of doubles would lose.
    strands.points[1] = {-0.0f, std::numeric_limits<float>::denorm_min(), 1e9f};
    strands.default_thickness = 0.008f;
    strands.default_transparency = 0.5f;
    strands.default_colour = {0.1f, 0.2f, 0.3f};
    return strands;
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void expect_same_bits(const Strands& a, const Strands& b) {
    EXPECT_EQ(a.first, b.first);
    EXPECT_TRUE(same_bits(a.points, b.points));
    EXPECT_TRUE(same_bits(a.thickness, b.thickness));
    EXPECT_TRUE(same_bits(a.transparency, b.transparency));
    EXPECT_TRUE(same_bits(a.colours, b.colours));
    EXPECT_TRUE(same_bits(a.uvs, b.uvs));
    EXPECT_EQ(a.default_thickness, b.default_thickness);
    EXPECT_EQ(a.default_transparency, b.default_transparency);
    EXPECT_EQ(a.default_colour, b.default_colour);
}

TEST_F(HairFile, RoundTripIsBitExact) {
    for (const bool attributes : {false, true}) {
        const Strands strands = random_strands(1, attributes);
        write_hair(folder / "a.hair", strands);
        expect_same_bits(read_hair(folder / "a.hair", &report), strands);
        EXPECT_THAT(report.warnings, IsEmpty());
        EXPECT_EQ(report.text, "Lancret");
    }
}

TEST_F(HairFile, ReadsTheDocumentedLayout) {
    Handmade file(3 | 4 | 32);
    for (int i = 0; i < 6; ++i) file.arrays += bytes_of(0.1f * float(i));
    for (int i = 0; i < 12; ++i) file.arrays += bytes_of(float(-i));
    const Strands strands = read(file.bytes());
    // The strand of one point, point 2, is dropped with its attributes.
    EXPECT_THAT(strands.first, ElementsAre(0, 2, 5));
    EXPECT_EQ(strands.points[1], Vec3f(3, 4, 5));
    EXPECT_EQ(strands.points[2], Vec3f(9, 10, 11));
    EXPECT_EQ(strands.thickness[2], 0.1f * 3);
    EXPECT_EQ(strands.uvs[2], Vec2f(-6, -7));
    EXPECT_THAT(strands.transparency, IsEmpty());
    EXPECT_THAT(strands.colours, IsEmpty());
    EXPECT_EQ(strands.default_thickness, 0.01f);
    EXPECT_EQ(strands.default_colour, Vec3f(0.25f, 0, 0));
    EXPECT_EQ(report.dropped_strands, 1u);
    EXPECT_EQ(report.text, "by hand");
    EXPECT_THAT(report.warnings, ElementsAre(HasSubstr("1 strands of a single point")));
}

TEST_F(HairFile, UsesTheDefaultSegmentsWithoutASegmentsArray) {
    Handmade file(2);
    file.segments.clear();
    set<std::uint32_t>(file.header, 16, 1);
    EXPECT_THAT(read(file.bytes()).first, ElementsAre(0, 2, 4, 6));
    set<std::uint32_t>(file.header, 16, 2);
    EXPECT_THAT(error_of(file.bytes()),
                HasSubstr(":byte 8: 6 points, but 3 strands of 2"));
}

TEST_F(HairFile, RejectsLowerCaseMagic) {
    Handmade file;
    std::memcpy(file.header.data(), "hair", 4);
    EXPECT_THAT(error_of(file.bytes()), HasSubstr("lower case"));
    std::memcpy(file.header.data(), "HAIX", 4);
    EXPECT_THAT(error_of(file.bytes()), HasSubstr("not a .hair file"));
}

TEST_F(HairFile, RejectsSegmentsThatCountPoints) {
    // A file of the right size whose array counts points, as some writers do.
    Handmade file;
    file.segments.clear();
    for (std::uint16_t s : {2, 1, 3}) file.segments += bytes_of(s);
    EXPECT_THAT(error_of(file.bytes()), HasSubstr(":byte 128: the strands have"));
    file.segments.clear();
    for (std::uint16_t s : {1, 0, 1}) file.segments += bytes_of(s);
    EXPECT_THAT(error_of(file.bytes()), HasSubstr("the strands have 5 points"));
}

TEST_F(HairFile, NamesStrandAndPointOfAnInvalidPosition) {
    const float bad[] = {std::numeric_limits<float>::quiet_NaN(),
                         -std::numeric_limits<float>::infinity(), 2e9f};
    for (const float value : bad) {
        Handmade file;
        set(file.arrays, 4 * 13, value);  // y of point 4: the second of strand 2
        const auto text = error_of(file.bytes());
        EXPECT_THAT(text, StartsWith((folder / "a.hair").string() + ":byte 182: "));
        EXPECT_THAT(text, HasSubstr("strand 2, point 1"));
    }
}

TEST_F(HairFile, RejectsAttributesThatAreNotNumbers) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::size_t floats[] = {0, 0, 6, 6, 18, 12};
    for (int bit = 2; bit < 6; ++bit) {
        Handmade file(3u | 1u << bit);
        for (std::size_t i = 0; i < floats[bit]; ++i) file.arrays += bytes_of(0.5f);
        EXPECT_EQ(error_of(file.bytes()), "") << bit;
        set(file.arrays, file.arrays.size() - 4, nan);
        EXPECT_THAT(error_of(file.bytes()), HasSubstr("strand 2, point 2")) << bit;
    }
    for (std::size_t at = 20; at < 40; at += 4) {
        Handmade file;
        set(file.header, at, nan);
        EXPECT_THAT(error_of(file.bytes()), HasSubstr(fmt::format(":byte {}:", at)));
    }
    Handmade file;
    set(file.header, 20, -1.0f);
    EXPECT_THAT(error_of(file.bytes()), HasSubstr("default thickness is -1"));
}

TEST_F(HairFile, RejectsAGroomWithoutHair) {
    Handmade file;
    set<std::uint32_t>(file.header, 4, 0);
    EXPECT_THAT(error_of(file.bytes()), HasSubstr("no strands"));
    Handmade single(2);
    single.segments.clear();
    set<std::uint32_t>(single.header, 4, 6);
    EXPECT_THAT(error_of(single.bytes()), HasSubstr("each of the 6 strands is a single"));
    EXPECT_THAT(error_of(Handmade(1).bytes()), HasSubstr("no points array"));
    EXPECT_THAT(error_of(""), HasSubstr("byte 0: the file ends within its header"));
}

TEST_F(HairFile, CountsThatWrapIn32BitsAreValidatedAgainstTheFile) {
    // 2^30 + 6 points of 12 bytes wrap to 72 bytes in 32 bits, exactly the size of the
    // file.
    Handmade file;
    set<std::uint32_t>(file.header, 8, 0x40000006);
    EXPECT_THAT(error_of(file.bytes()), HasSubstr("need 12884902"));
    // 2^32 - 1 strands of 2^32 segments: the product wraps to 0 without 64 bits.
    Handmade wide(2);
    set<std::uint32_t>(wide.header, 4, 0xffffffff);
    set<std::uint32_t>(wide.header, 16, 0xffffffff);
    EXPECT_THAT(error_of(wide.bytes()), HasSubstr("18446744069414584320"));
}

TEST_F(HairFile, TrailingBytesAndUnknownArraysAreWarnings) {
    Handmade file(3 | 64);
    EXPECT_EQ(read(file.bytes() + "xyz").size(), 2u);
    EXPECT_THAT(report.warnings, ElementsAre(HasSubstr("unknown array flags 0x40"),
                                             HasSubstr(":byte 206: 3 bytes after"),
                                             HasSubstr("single point")));
}

TEST_F(HairFile, EveryTruncationIsAnInputError) {
    const std::string bytes = Handmade().bytes();
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        EXPECT_THAT(error_of(bytes.substr(0, length)),
                    HasSubstr(fmt::format(":byte {}: the file ends", length)));
    }
}

TEST_F(HairFile, AnyFlippedBytesParseOrAreAnInputError) {
    write_hair(folder / "b.hair", random_strands(2, true));
    const std::string good = read_bytes(folder / "b.hair");
    std::mt19937 random(3);
    int parsed = 0;
    for (int i = 0; i < 5000; ++i) {
        std::string bytes = good;
        // Half of the flips are in the header and the segments, which matter most.
        for (unsigned flips = 1 + random() % 4; flips > 0; --flips) {
            bytes[random() % (i % 2 ? 168 : bytes.size())] = char(random());
        }
        try {
            const Strands strands = read(bytes);
            ++parsed;
            ASSERT_EQ(strands.first.back(), strands.points.size());
            for (std::size_t s = 0; s < strands.size(); ++s) {
                ASSERT_GE(strands.strand(s).size(), 2u);
            }
            for (const Vec3f& p : strands.points) ASSERT_TRUE(p.allFinite());
        } catch (const InputError&) {
        }
    }
    EXPECT_GT(parsed, 500);
    EXPECT_LT(parsed, 4500);
}

TEST_F(HairFile, MissingFilesAndFoldersAreInputErrors) {
    EXPECT_THAT(input_error([&] { read_hair(folder / "none.hair"); }),
                HasSubstr("none.hair: there is no such file"));
    EXPECT_THAT(input_error([&] { read_hair(folder.path); }),
                HasSubstr("not a regular file"));
}

TEST_F(HairFile, WriterRejectsWhatTheFormatCannotStore) {
    Strands strands;
    EXPECT_THROW(write_hair(folder / "a.hair", strands), std::invalid_argument);
    strands.first = {0, 1};
    strands.points.resize(1, Vec3f::Zero());
    EXPECT_THROW(write_hair(folder / "a.hair", strands), std::invalid_argument);
    strands.first = {0, 65537};
    strands.points.resize(65537, Vec3f::Zero());
    EXPECT_THAT(input_error([&] { write_hair(folder / "a.hair", strands); }),
                HasSubstr("strand 0 has 65536 segments"));
    strands.first = {0, 65536};
    strands.points.resize(65536, Vec3f::Zero());
    write_hair(folder / "a.hair", strands);
    EXPECT_EQ(read_hair(folder / "a.hair").points.size(), 65536u);
    strands.thickness.resize(3);
    EXPECT_THROW(write_hair(folder / "a.hair", strands), std::invalid_argument);
}

TEST_F(HairFile, ReadsRealGrooms) {
    const std::filesystem::path data = LANCRET_SOURCE_DIR "/../shared/data";
    if (!std::filesystem::exists(data / "sintel.hair")) {
        GTEST_SKIP() << "no real grooms in " << data;
    }
    const Strands sintel = read_hair(data / "sintel.hair", &report);
    EXPECT_EQ(sintel.size(), 11400u);
    EXPECT_EQ(sintel.points.size(), 182400u);
    EXPECT_THAT(report.warnings, IsEmpty());
    const Strands fur = read_hair(data / "fur.hair", &report);
    EXPECT_EQ(fur.size(), 50000u);
    EXPECT_EQ(fur.strand(49999).size(), 4u);
    EXPECT_EQ(fur.thickness.size(), 200000u);
    EXPECT_EQ(fur.default_thickness, 0);
    EXPECT_THAT(report.warnings, IsEmpty());
    write_hair(folder / "fur.hair", fur);
    expect_same_bits(read_hair(folder / "fur.hair"), fur);
}

}  // namespace
}  // namespace lancret
