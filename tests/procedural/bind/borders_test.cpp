#include "procedural/bind/borders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "guides/files/hair_file.h"
#include "guides/files/hair_file_write.h"
#include "guides/files/obj_file.h"
#include "procedural/groom/ready_groom.h"
#include "tests/guides/base/temporary_folder.h"

namespace lancret {
namespace {

using testing::HasSubstr;

GroomSettings small_groom() {
    GroomSettings groom;
    groom.name = "small.toml";
    groom.made.strands = 300;
    groom.guides.number = 150;
    groom.fit.segments = 3;
    groom.strands = 4000;
    groom.intervals = 3;
    return groom;
}

TEST(Borders, NoChildOfTheMadeGroomHasAGuideAcrossItsParting) {
    const ReadyGroom made = make_ready_groom(small_groom());
    const Binding& binding = made.binding;
    // The parting lies in front of the crown and behind the hairline.
    std::size_t tested = 0;
    for (std::size_t i = 0; i < binding.size(); ++i) {
        const Vec3f& child = binding.roots.positions[i];
        if (child.z() < 0 || child.z() > 7) continue;
        for (std::size_t j = 4 * i; j < 4 * i + 4; ++j) {
            const Vec3& guide = made.placed.guides.root_positions[binding.guides[j]];
            if (guide.z() < 0 || guide.z() > 7) continue;
            ++tested;
            EXPECT_GT(double(child.x()) * guide.x(), 0) << "child " << i;
        }
    }
    EXPECT_GT(tested, 2000u);
    EXPECT_EQ(binding.report.no_guide_in_sight, 0u);
}

TEST(Borders, AGroomsPartingReplacesTheMadeOne) {
    GroomSettings groom = small_groom();
    // From ear to ear, drawn above the head.
    groom.partings = {{{-7, 8, 0.5}, {7, 8, 0.5}}};
    const ReadyGroom made = make_ready_groom(groom);
    ASSERT_EQ(made.placed.partings.size(), 1u);
    for (const Vec3& p : made.placed.partings[0]) {
        EXPECT_NEAR(p.cwiseQuotient(kMadeHead).norm(), 1, 0.01);
    }
    EXPECT_THAT(made.placed.report.warnings,
                testing::Contains(HasSubstr("off the scalp")));
}

TEST(Borders, RegionsOfStrandsAreThoseOfTheirLinesEvenIfSomeAreDropped) {
    const TemporaryFolder folder;
    // Strands 1 and 3 of the file are single points; the others are at x = 0, 2, 4.
    Strands strands;
    for (int i = 0; i < 3; ++i) {
        for (int p = 0; p < 4; ++p) {
            strands.points.emplace_back(2.0f * float(i), 0.0f, float(p));
        }
        strands.first.push_back(std::uint32_t(strands.points.size()));
    }
    write_hair(folder / "three.hair", strands);
    std::string bytes = read_bytes(folder / "three.hair");
    const auto insert = [&](std::size_t offset, const void* data, std::size_t size) {
        bytes.insert(offset, static_cast<const char*>(data), size);
    };
    const float place[3] = {9, 9, 9};
    const std::uint16_t none = 0;
    const std::size_t points = 128 + 3 * 2;
    insert(points + 8 * 12, place, 12);
    insert(points + 4 * 12, place, 12);
    insert(128 + 2 * 2, &none, 2);
    insert(128 + 1 * 2, &none, 2);
    const std::uint32_t counts[2] = {5, 14};
    bytes.replace(4, 8, reinterpret_cast<const char*>(counts), 8);
    write_bytes(folder / "five.hair", bytes);
    write_bytes(folder / "ids.txt", "10\n99\n11\n99\n12\n");

    GroomSettings groom;
    groom.name = "five.toml";
    groom.strands_file = folder / "five.hair";
    groom.regions.ids = folder / "ids.txt";
    groom.fit.segments = 2;
    const ReadyGroom made = make_ready_groom(groom);
    EXPECT_EQ(made.placed.grown.regions.strands,
              (std::vector<std::uint32_t>{10, 11, 12}));
    // Each child has the region of its strand, and so only that strand's guide.
    ASSERT_EQ(made.binding.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t k = std::size_t(made.binding.neighbours);
        EXPECT_EQ(made.binding.weights[i * k], 1);
        EXPECT_EQ(made.placed.guides.root_positions[made.binding.guides[i * k]].x(),
                  double(made.binding.roots.positions[i].x()));
    }
}

TEST(Borders, EveryRegionWithStrandsGetsAGuide) {
    const TemporaryFolder folder;
    std::string ids;
    // Five strands have a region each.
    for (int i = 0; i < 300; ++i) ids += i % 60 == 7 ? std::to_string(i) + "\n" : "0\n";
    write_bytes(folder / "ids.txt", ids);
    GroomSettings groom = small_groom();
    groom.guides.number = 4;
    groom.regions.ids = folder / "ids.txt";
    const ReadyGroom made = make_ready_groom(groom);
    std::vector<std::uint32_t> regions = made.placed.guide_regions;
    std::ranges::sort(regions);
    regions.erase(std::ranges::unique(regions).begin(), regions.end());
    EXPECT_EQ(regions, (std::vector<std::uint32_t>{0, 7, 67, 127, 187, 247}));
    EXPECT_EQ(made.placed.guides.size(), made.placed.guide_regions.size());
    EXPECT_EQ(made.binding.report.no_guide_in_region, 0u);
    EXPECT_THAT(made.placed.report.warnings,
                testing::Contains(HasSubstr("were given one each")));
}

TEST(Borders, ATextureNeedsUvs) {
    const TemporaryFolder folder;
    GroomSettings groom = small_groom();
    groom.regions.texture = folder / "none.png";
    EXPECT_THROW(make_ready_groom(groom), InputError);  // there is no such image
    const MadeGroom made = make_groom(groom.made);
    TriangleMesh bare = made.scalp;
    bare.uvs.clear();
    write_obj(folder / "bare.obj", bare);
    groom.scalp_file = folder / "bare.obj";
    try {
        make_ready_groom(groom);
        ADD_FAILURE() << "no error";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("small.toml: the texture of [regions]"));
    }
}

TEST(Borders, ATextureDividesChildrenAndGuidesAlike) {
    const ReadyGroom made = make_ready_groom(small_groom());
    // A map of two halves along u, which runs around the head.
    Regions regions;
    regions.map = RegionMap{2, 1, {0, 1}, 2};
    const auto of_guides = regions_at(regions, made.placed.scalp, made.placed.grown.roots,
                                      made.placed.guides.root_positions);
    const auto of_children =
        child_regions(regions, made.placed.grown.roots, made.binding.roots);
    const auto expected = [](double x) { return x > 0 ? 0u : 1u; };  // u from +Z over +X
    std::size_t clear = 0;
    for (std::size_t g = 0; g < of_guides.size(); ++g) {
        const double x = made.placed.guides.root_positions[g].x();
        if (std::abs(x) < 0.01) continue;
        EXPECT_EQ(of_guides[g], expected(x)) << g;
    }
    for (std::size_t i = 0; i < of_children.size(); ++i) {
        const double x = double(made.binding.roots.positions[i].x());
        if (std::abs(x) < 0.01) continue;
        ++clear;
        EXPECT_EQ(of_children[i], expected(x)) << i;
    }
    EXPECT_GT(clear, 3900u);
}

}  // namespace
}  // namespace lancret
