// Each subcommand on a valid groom: its files can be read back and its figures are those
// of the groom.

#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "guides/files/guide_cache.h"
#include "guides/strand/curve.h"
#include "render_test/files/read_image.h"
#include "render_test/image/image.h"
#include "tests/tools/reports.h"
#include "tests/tools/small_grooms.h"

namespace lancret {
namespace {

using testing::HasSubstr;

/// A run that succeeded and printed nothing on stderr.
testing::Matcher<const CommandRun&> works_silently() {
    return testing::AllOf(testing::Field("exit code", &CommandRun::exit_code, 0),
                          testing::Field("stderr", &CommandRun::err, ""));
}

TEST(Preview, PngShowsHairOnTheBackground) {
    const SmallGrooms folder;
    const std::string png = folder.at("a.png");
    ASSERT_THAT(lancret({"preview", folder.made, "-o", png}), works_silently());
    const Texture picture = read_texture(png);
    ASSERT_EQ(picture.width, 32);
    ASSERT_EQ(picture.height, 32);
    // The corners show the background, 0.18, to half a step of the 8-bit code: the slope
    // of the linear value over the code is below 2.4 * 0.46^1.4 / 1.055 < 0.8, over 510.
    for (const std::size_t corner : {0u, 31u, 31u * 32u, 32u * 32u - 1u}) {
        EXPECT_NEAR(picture.texels[corner].x(), 0.18, 0.8 / 510) << corner;
    }
    // The middle does not: black hair is darker, and the skin of the head is redder.
    const Vec3f middle = picture.texels[16 * 32 + 16];
    EXPECT_GT((middle - Vec3f::Constant(0.18f)).norm(), 0.02);
}

TEST(Preview, ExrHasAllLayersInTheRequestedSize) {
    const SmallGrooms folder;
    const std::string exr = folder.at("a.exr");
    const std::string wide = folder.file(
        "wide.toml", read_bytes(folder.made) + "[width]\nroot = 0.1\ntip = 0.1\n");
    ASSERT_THAT(
        lancret({"preview", wide, "-o", exr, "--size", "24x16", "--samples", "4"}),
        works_silently());
    Imf::MultiPartInputFile file(exr.c_str());
    const Imath::Box2i window = file.header(0).dataWindow();
    ASSERT_EQ(window.max.x - window.min.x + 1, 24);
    ASSERT_EQ(window.max.y - window.min.y + 1, 16);
    std::map<std::string, int> parts;
    for (int p = 0; p < file.parts(); ++p) parts[file.header(p).name()] = p;
    EXPECT_EQ(parts, (std::map<std::string, int>{{"rgba", 0},
                                                 {"depth", 1},
                                                 {"N", 2},
                                                 {"T", 3},
                                                 {"id", 4},
                                                 {"motion", 5},
                                                 {"variance", 6},
                                                 {"CryptoObject", 7},
                                                 {"CryptoMaterial", 8}}));
    const auto read = [&](int part, const char* name, Imf::PixelType type, void* data) {
        Imf::InputPart input(file, part);
        Imf::FrameBuffer frame;
        frame.insert(name, Imf::Slice(type, static_cast<char*>(data), 4, 96));
        input.setFrameBuffer(frame);
        input.readPixels(window.min.y, window.max.y);
    };
    std::vector<std::uint32_t> id(24 * 16);
    std::vector<float> depth(24 * 16);
    read(4, "id", Imf::UINT, id.data());
    read(1, "Z", Imf::FLOAT, depth.data());
    std::size_t of_strands = 0, of_mesh = 0;
    for (std::size_t i = 0; i < id.size(); ++i) {
        of_mesh += id[i] == kMeshId;
        of_strands += id[i] < 60;  // of 60 strands, one millimetre wide
        EXPECT_TRUE(id[i] < 60 || id[i] >= kMeshId) << id[i];
        EXPECT_TRUE(depth[i] > 0 || id[i] == kNothingId);
    }
    EXPECT_GT(of_mesh, 0u);
    EXPECT_GT(of_strands, 0u);
}

TEST(Preview, WritesADeepPictureForEachFrameOrView) {
    const SmallGrooms folder;
    ASSERT_THAT(lancret({"preview", folder.made, "-o", folder.at("a.##.png"), "--deep",
                         folder.at("d.##.exr"), "--turntable", "2", "--size", "16x12",
                         "--samples", "2"}),
                works_silently());
    for (const char* name : {"d.01.exr", "d.02.exr"}) {
        const Imf::MultiPartInputFile file(folder.at(name).c_str());
        ASSERT_EQ(file.parts(), 1);
        EXPECT_EQ(file.header(0).type(), Imf::DEEPSCANLINE);
        EXPECT_EQ(file.header(0).dataWindow().max, Imath::V2i(15, 11));
    }
}

TEST(Preview, DenoisingChangesHairButNotTheBackground) {
    const SmallGrooms folder;
    const auto picture = [&](const char* name, std::vector<std::string> more) {
        std::vector<std::string> words{"preview",       folder.made, "-o",
                                       folder.at(name), "--size",    "16x12",
                                       "--samples",     "2"};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_THAT(lancret(words), works_silently());
        return read_texture(folder.at(name));
    };
    const Texture before = picture("a.png", {});
    const Texture after = picture("b.png", {"--denoise"});
    EXPECT_NE(before.texels, after.texels);
    // The corners show only the background.
    for (const std::size_t corner : {0u, 15u, 11u * 16u}) {
        EXPECT_EQ(before.texels[corner], after.texels[corner]);
    }
}

TEST(Preview, StatsHaveTimesCountsAndBytes) {
    const SmallGrooms folder;
    const std::string json = folder.at("s.json");
    ASSERT_THAT(lancret({"preview", folder.made, "-o", folder.at("a.png"), "--intervals",
                         "10", "--stats", json}),
                works_silently());
    const nlohmann::json stats = json_of(json);
    for (const char* stage : {"load", "fit", "bind", "expand", "bvh", "render"}) {
        ASSERT_TRUE(stats.at("seconds").at(stage).is_number()) << stage;
        EXPECT_GE(stats["seconds"][stage], 0) << stage;
    }
    EXPECT_EQ(stats.at("strands"), 60);
    EXPECT_EQ(stats.at("guides"), 40);
    EXPECT_EQ(stats.at("points"), 60 * 13);  // a B-spline of n intervals has n + 3
    // Strands are stored chunk by chunk, so each has its id besides.
    EXPECT_EQ(stats.at("bytes").at("curves"), 60 * 13 * 16 + 60 * 10 * 4 + 60 * 4);
    EXPECT_GT(stats.at("bytes").at("bvh"), 0);
    EXPECT_GT(stats.at("peak_rss"), 1'000'000);
    EXPECT_EQ(stats.at("image").at("width"), 32);
}

TEST(Check, JsonHasEveryFigure) {
    const SmallGrooms folder;
    const std::string file = folder.at("r.json");
    const CommandRun run = lancret({"check", folder.made, "--json", file});
    EXPECT_THAT(run, works_silently());
    EXPECT_THAT(run.out, HasSubstr("PASS"));
    const nlohmann::json report = json_of(file);
    EXPECT_EQ(report.at("strands"), 60);
    EXPECT_EQ(report.at("pass"), true);
    EXPECT_EQ(report.at("failed"), 0);
    // The default tolerances of the check.
    EXPECT_LE(report.at("orthogonality").at("max"), 1e-6);
    EXPECT_LE(report.at("length").at("max_relative_error"), 1e-5);
    EXPECT_EQ(report.at("worst").size(), 10u);
    EXPECT_EQ(report.at("blend"), "detail");
}

TEST(Check, FailsIfABlendShortensCurls) {
    const SmallGrooms folder;
    const std::string file = folder.at("r.json");
    const CommandRun run =
        lancret({"check", folder.made, "--blend", "position", "--json", file});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.err, "");
    EXPECT_THAT(run.out, HasSubstr("FAIL"));
    const nlohmann::json report = json_of(file);
    EXPECT_EQ(report.at("pass"), false);
    EXPECT_GT(report.at("failed"), 0);
    EXPECT_GT(report.at("length").at("max_relative_error"), 1e-5);
}

TEST(Check, FailsIfAToleranceIsZero) {
    const SmallGrooms folder;
    EXPECT_EQ(lancret({"check", folder.made, "--distance", "0"}).exit_code, 1);
}

/// The polyline's length of each strand, cm.
std::vector<double> lengths_of(const Strands& strands) {
    std::vector<double> out;
    for (std::size_t i = 0; i < strands.size(); ++i) {
        double sum = 0;
        const auto points = strands.strand(i);
        for (std::size_t j = 1; j < points.size(); ++j) {
            sum += (points[j].cast<double>() - points[j - 1].cast<double>()).norm();
        }
        out.push_back(sum);
    }
    return out;
}

TEST(Expand, HairReadsBackWithPointsOnTheStrands) {
    const SmallGrooms folder;
    const std::string file = folder.at("c.hair");
    ASSERT_THAT(lancret({"expand", folder.hair, "--scalp", folder.obj, "--strands", "50",
                         "--intervals", "64", "-o", file}),
                works_silently());
    const Strands strands = read_hair(file);
    ASSERT_EQ(strands.size(), 50u);
    EXPECT_EQ(strands.points.size(), 50u * 65u);
    // All guides are translated copies of one curve, so a child is as long as each of
    // them. The hairs of the lawn turn by 9 radians at a radius of 0.2 cm while they rise
    // 5 cm, with their points on that helix. The fit changes the length by less than its
    // distance from the points; 1 % is allowed here. Chords of 64 steps are shorter than
    // the arc by at most (9/64)^2 / 24 < 0.1 %.
    const double guide = std::hypot(5, 9 * 0.2);
    for (const double length : lengths_of(strands)) {
        EXPECT_NEAR(length, guide, 0.011 * guide);
    }
    for (std::size_t i = 0; i < strands.size(); ++i) {
        // Roots lie on the square [0, 4]^2 at z = 0, up to round-off.
        const Vec3f root = strands.strand(i).front();
        EXPECT_NEAR(root.z(), 0, 1e-6);
        EXPECT_GE(root.head<2>().minCoeff(), 0);
        EXPECT_LE(root.head<2>().maxCoeff(), 4);
    }
}

TEST(Expand, TextHasFourNumbersPerLineAndABlankLineBetweenStrands) {
    const SmallGrooms folder;
    const std::string file = folder.at("c.txt");
    ASSERT_THAT(lancret({"expand", folder.made, "--intervals", "5", "-o", file}),
                works_silently());
    std::istringstream text(read_bytes(file));
    std::size_t strands = 1, points = 0;
    for (std::string line; std::getline(text, line);) {
        if (line.empty()) {
            ++strands;
            continue;
        }
        std::istringstream numbers(line);
        double x, y, z, r;
        ASSERT_TRUE(numbers >> x >> y >> z >> r) << line;
        // Half the default widths, linear; the outermost control points lie one interval
        // beyond root and tip.
        EXPECT_GE(r, 0.002 - 0.002 / 5 - 1e-9);
        EXPECT_LE(r, 0.004 + 0.002 / 5 + 1e-9);
        ++points;
    }
    EXPECT_EQ(strands, 60u);
    EXPECT_EQ(points, 60u * 8u);
}

TEST(ExpandAndPreview, SameBytesOnOneCoreAsOnAll) {
    const SmallGrooms folder;
    if (run_words({"taskset", "-c", "0", "true"}).exit_code != 0) {
        GTEST_SKIP() << "needs taskset";
    }
    const auto both = [&](const char* name, std::vector<std::string> words) {
        const std::string all = folder.at(std::string("all") + name);
        const std::string one = folder.at(std::string("one") + name);
        words.insert(words.begin(), LANCRET_COMMAND);
        words.push_back(all);
        ASSERT_THAT(run_words(words), works_silently());
        words.back() = one;
        words.insert(words.begin(), {"taskset", "-c", "0"});
        ASSERT_THAT(run_words(words), works_silently());
        EXPECT_EQ(read_bytes(all), read_bytes(one)) << name;
    };
    both(".hair", {"expand", folder.made, "-o"});
    both(".exr", {"preview", folder.made, "-o"});
}

TEST(Expand, DependsOnTheSeed) {
    const SmallGrooms folder;
    const auto bytes = [&](const char* seed) {
        const std::string file = folder.at("c.hair");
        EXPECT_THAT(lancret({"expand", folder.made, "--seed", seed, "-o", file}),
                    works_silently());
        return read_bytes(file);
    };
    const std::string zero = bytes("0");
    EXPECT_EQ(bytes("0"), zero);
    EXPECT_NE(bytes("18446744073709551615"), zero);
}

TEST(Fit, CacheContainsTheGuidesAndCanBeUsedAsAGroom) {
    const SmallGrooms folder;
    const std::string cache = folder.at("g.h5");
    const CommandRun fit =
        lancret({"fit", folder.hair, "--guides", "9", "--segments", "5", "-o", cache});
    ASSERT_THAT(fit, works_silently());
    EXPECT_THAT(fit.out, HasSubstr("9 guides of 5 segments from 25 strands"));
    const GuideCacheInfo info = guide_cache_info(cache);
    EXPECT_EQ(info.guides, 9u);
    EXPECT_EQ(info.segments, 5);
    EXPECT_THAT(lancret({"check", cache, "--scalp", folder.obj, "--strands", "40"}),
                works_silently());
    const std::string png = folder.at("a.png");
    EXPECT_THAT(lancret({"preview", cache, "--scalp", folder.obj, "--strands", "40",
                         "--size", "16x16", "--samples", "1", "-o", png}),
                works_silently());
    EXPECT_EQ(read_texture(png).width, 16);
    EXPECT_THAT(lancret({"fit", cache}), refuses_with("g.h5", "contains guides"));
}

TEST(Fit, PercentageOfTheStrandsBecomesGuides) {
    const SmallGrooms folder;
    const CommandRun run = lancret({"fit", folder.hair, "--guides", "20%"});
    ASSERT_THAT(run, works_silently());
    EXPECT_THAT(run.out, HasSubstr("5 guides of"));
}

TEST(Info, DescribesEachKindOfFile) {
    const SmallGrooms folder;
    const CommandRun hair = lancret({"info", folder.hair});
    ASSERT_THAT(hair, works_silently());
    EXPECT_THAT(hair.out, HasSubstr("25 strands, 600 points"));
    EXPECT_THAT(hair.out, HasSubstr("points per strand: 24 to 24"));
    const CommandRun obj = lancret({"info", folder.obj});
    ASSERT_THAT(obj, works_silently());
    EXPECT_THAT(obj.out, HasSubstr("16 vertices, 18 triangles, with UVs"));
    EXPECT_THAT(obj.out, HasSubstr("area: 16 cm^2"));
    const CommandRun made = lancret({"info", folder.made});
    ASSERT_THAT(made, works_silently());
    EXPECT_THAT(made.out, HasSubstr("60 children, blend detail"));
    const std::string cache = folder.at("g.h5");
    ASSERT_THAT(lancret({"fit", folder.hair, "-o", cache, "--segments", "5"}),
                works_silently());
    const CommandRun guides = lancret({"info", cache});
    ASSERT_THAT(guides, works_silently());
    EXPECT_THAT(guides.out, HasSubstr("25 guides of 5 segments, 1 frames from 1"));
}

}  // namespace
}  // namespace lancret
