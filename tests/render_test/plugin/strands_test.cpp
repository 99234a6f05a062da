// What the path tracer has through the plugin, beside what the library grows directly.

#include "render_test/plugin/strands.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>

#include "procedural/check/values.h"
#include "procedural/groom/groom_source.h"
#include "procedural/groom/ready_groom.h"
#include "render_test/scene/embree_scene.h"
#include "tests/guides/base/temporary_folder.h"

namespace lancret {
namespace {

struct SmallGroom : TemporaryFolder {
    std::string file = (*this / "small.toml").string();

    explicit SmallGroom(const std::string& strands = "") {
        write_bytes(file,
                    "[guides]\ncount = 60\nmade.strands = 200\n"
                    "[strands]\ncount = 9000\n" +
                        strands);
    }
    ReadyGroom direct() const {
        GroomSource source;
        source.path = file;
        return make_ready_groom(read_groom_source(source).groom);
    }
};

bool same(std::span<const Point4f> a, std::span<const Point4f> b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

void expect_same_strands(const Curves& curves, const Curves& direct) {
    ASSERT_EQ(curves.strands, direct.strands);
    EXPECT_EQ(curves.points.size(), direct.points.size());
    EXPECT_EQ(curves.basis, direct.basis);
    EXPECT_EQ(curves.shape, direct.shape);
    std::map<std::uint32_t, std::uint32_t> places;
    for (std::uint32_t i = 0; i < direct.strands; ++i) places[direct.id_of(i)] = i;
    for (std::uint32_t i = 0; i < curves.strands; ++i) {
        const std::uint32_t other = places.at(curves.id_of(i));
        ASSERT_TRUE(same(curves.of_strand(curves.points, i),
                         direct.of_strand(direct.points, other)))
            << i;
        ASSERT_TRUE(same(curves.of_strand(curves.tangents, i),
                         direct.of_strand(direct.tangents, other)))
            << i;
        ASSERT_TRUE(same(curves.of_strand(curves.normals, i),
                         direct.of_strand(direct.normals, other)))
            << i;
    }
}

TEST(PluginStrands, AreThoseOfExpandBitForBitInAnyBasisAndShape) {
    for (const char* settings : {"", "curve = 'hermite'\n", "shape = 'ribbon'\n",
                                 "shape = 'round'\ndensity = 0.4\n"}) {
        const SmallGroom folder(settings);
        const PluginGroom groom(folder.file, {}, {});
        ASSERT_GT(groom.info().chunks, 1u);
        const PluginStrands strands(groom, {.times = {0}, .pixels = {}});
        const std::vector<Curves> curves = strands.curves();
        const ReadyGroom ready = folder.direct();
        expect_same_strands(
            curves.at(0), expand(ready.binding, rest_guides(ready), ready.groom.expand));
        // Embree is given them only where tables and buffers fit each other.
        EXPECT_NO_THROW(HairScene(curves.at(0), nullptr)) << settings;
        EXPECT_EQ(strands.info().strands, curves[0].strands);
    }
}

TEST(PluginStrands, AllTimesOfAStillGroomAreOne) {
    const SmallGroom folder;
    const PluginGroom groom(folder.file, {}, {});
    const PluginStrands strands(groom, {.times = {0, 1, 2}, .pixels = {}});
    const std::vector<Curves> curves = strands.curves();
    ASSERT_EQ(curves.size(), 3u);
    expect_same_strands(curves[2], curves[0]);
    EXPECT_TRUE(groom.is_still(std::array{0.0, 2.0}));
}

TEST(PluginStrands, LevelOfDetailGrowsFewerOfThem) {
    const SmallGroom folder;
    const PluginGroom groom(folder.file, {}, {});
    const std::vector<double> pixels(groom.info().chunks, 100);
    const PluginStrands few(groom,
                            {.times = {0}, .pixels = pixels, .strands_per_pixel = 2});
    // 200 a chunk, and a tenth more that fade.
    EXPECT_NEAR(double(few.size()), 200.0 * groom.info().chunks,
                60.0 * groom.info().chunks);
}

TEST(PluginStrands, FiguresStandWhereTheirStrandsDo) {
    const SmallGroom folder;
    const PluginGroom groom(folder.file, {}, {});
    const PluginStrands strands(groom, {.times = {0}, .pixels = {}});
    const Curves curves = std::move(strands.curves().front());
    const StrandValues curvature = strands.figures(LANCRET_CURVATURE, 0, curves);
    const StrandValues frames = strands.figures(LANCRET_ORTHOGONALITY, 0, curves);
    const StrandGuides guides = strands.guides();
    ASSERT_EQ(curvature.strands(), curves.strands);
    const ReadyGroom direct = folder.direct();
    const Binding& binding = direct.binding;
    const StrandValues own =
        curvature_values(binding, rest_guides(direct), direct.groom.expand.blend);
    std::map<std::uint32_t, std::uint32_t> places;
    for (std::uint32_t i = 0; i < binding.size(); ++i) places[binding.roots.id(i)] = i;
    for (std::uint32_t i = 0; i < curves.strands; ++i) {
        const std::uint32_t segments = curves.class_of(i).segments;
        ASSERT_EQ(curvature.of(i).size(), segments);
        ASSERT_EQ(frames.of(i).size(), segments + 1);
        const std::uint32_t place = places.at(curves.id_of(i));
        ASSERT_TRUE(std::ranges::equal(curvature.of(i), own.of(place))) << i;
        const std::size_t n = guides.neighbours;
        for (std::size_t k = 0; k < n; ++k) {
            ASSERT_EQ(guides.guides[i * n + k], binding.guides[place * n + k]);
            ASSERT_EQ(guides.weights[i * n + k], binding.weights[place * n + k]);
        }
    }
}

TEST(PluginGroom, WhatTheGroomHasAtFaultIsTold) {
    const SmallGroom folder("blend = 'none'\n");
    EXPECT_THAT(input_error([&] { PluginGroom(folder.file, {}, {}); }),
                testing::HasSubstr(folder.file + ":6"));
    const SmallGroom good;
    const std::vector<PluginParameter> odd{{"strands.cuont", std::nullopt, 3}};
    EXPECT_THAT(input_error([&] { PluginGroom(good.file, odd, {}); }),
                testing::HasSubstr("cuont"));
}

TEST(PluginGroom, ErrorsBelongToTheirGroomAndThread) {
    const SmallGroom folder;
    const PluginGroom first(folder.file, {}, {}), second(folder.file, {}, {});
    const auto fail = [](const PluginGroom& groom, double time) {
        return groom.plugin()->groom_is_still(groom.handle(), &time, 1, nullptr);
    };
    const auto message = [](const PluginGroom& groom, lancret_status status) {
        try {
            groom.throw_if_failed(status);
        } catch (const std::runtime_error& error) {
            return std::string(error.what());
        }
        return std::string("none");
    };
    const lancret_status status = fail(first, 0);
    ASSERT_EQ(status, LANCRET_BAD_CALL);
    std::string elsewhere;
    std::thread([&] { elsewhere = message(first, status); }).join();
    EXPECT_THAT(elsewhere, testing::EndsWith("status 2: "));
    EXPECT_THAT(message(second, status), testing::EndsWith("status 2: "));
    EXPECT_THAT(message(first, status), testing::EndsWith("status 2: still is null"));
    EXPECT_EQ(message(first, LANCRET_OK), "none");
}

TEST(PluginGroom, StagesAreTold) {
    const SmallGroom folder;
    std::string told;
    const PluginGroom groom(
        folder.file, {},
        {.stage = [&](const std::string& s) { told += s + "\n"; }, .warning = {}});
    EXPECT_THAT(told, testing::HasSubstr("fit"));
    ASSERT_TRUE(groom.head(0).has_value());
    EXPECT_GT(groom.head(0)->triangles.size(), 100u);
}

}  // namespace
}  // namespace lancret
