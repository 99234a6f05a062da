#include "procedural/groom/ready_groom.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "guides/files/guide_cache.h"
#include "guides/files/guide_cache_write.h"
#include "guides/files/hair_file.h"
#include "guides/files/hair_file_write.h"
#include "procedural/check/check.h"
#include "tests/guides/base/temporary_folder.h"
#include "tests/procedural/made_hair.h"
#include "tests/procedural/small_groom.h"

namespace lancret {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

GroomSettings small_made_groom() {
    return test::small_groom({.made = 60, .guides = 20, .segments = 24, .strands = 400});
}

CheckReport check_of(const ReadyGroom& ready, Blend blend) {
    ExpandSettings settings = ready.groom.expand;
    settings.blend = blend;
    const Curves curves = expand(ready.binding, ready.profiles, settings);
    CheckTolerances tolerances;
    tolerances.distance = ready.groom.tolerance;
    const ClassedGuides guides =
        test::one_class(ready.profiles, ready.binding.guide_normals, blend);
    return check_strands({ready.binding, ready.placed.guides, guides, curves, settings,
                          ready.groom.bind.length_scale, tolerances});
}

double median(std::vector<double> values) {
    std::ranges::nth_element(values, values.begin() + values.size() / 2);
    return values[values.size() / 2];
}

TEST(ReadyGroom, MakesTheSmallGroomFromEndToEnd) {
    std::vector<std::string> stages;
    const ReadyGroom ready = make_ready_groom(small_made_groom(), [&](GroomStage stage) {
        stages.emplace_back(stage_name(stage));
    });
    EXPECT_EQ(stages, (std::vector<std::string>{"load", "fit", "bind"}));
    EXPECT_EQ(ready.placed.report.groom_strands, 60u);
    EXPECT_EQ(ready.placed.guides.size(), 20u);
    EXPECT_EQ(ready.placed.fits.size(), 20u);
    EXPECT_EQ(ready.placed.normals.size(), 20u);
    EXPECT_EQ(ready.binding.size(), 400u);
    EXPECT_EQ(ready.binding.roots.uvs.size(), 400u);
    EXPECT_EQ(ready.profiles.count % 24, 0);
    EXPECT_TRUE(ready.placed.whole_scalp);
    ASSERT_TRUE(ready.placed.body);
    for (const Vec3f& p : ready.binding.roots.positions) {
        // The mesh is inscribed in the ellipsoid: its vertices lie on it.
        const double level = p.cast<double>().cwiseQuotient(kMadeHead).squaredNorm();
        EXPECT_LE(level, 1 + 1e-5);
        EXPECT_GT(level, 0.97);
    }
    // Guides have 25 to 35 cm, and so do their children.
    for (const float length : ready.binding.lengths) {
        EXPECT_GT(length, 24);
        EXPECT_LT(length, 36);
    }
}

TEST(ReadyGroom, EveryChildOfTheSmallGroomPassesTheCheck) {
    const ReadyGroom ready = make_ready_groom(small_made_groom());
    const CheckReport report = check_of(ready, Blend::option1);
    std::size_t failed = 0;
    double longest = 0;
    for (const StrandCheck& s : report.strands) {
        longest = std::max(longest, std::abs(double(s.length_error)));
        EXPECT_LE(s.orthogonality, 1e-6);
        EXPECT_LE(s.root_distance, 1e-3);
        EXPECT_TRUE(s.finite && s.tip_within_reach && s.inside_hull) << s.strand;
        failed += !report.passes(s);
    }
    EXPECT_LE(longest, 1e-5);
    EXPECT_EQ(failed, 0u);
}

TEST(ReadyGroom, BlendOfPositionsLosesTheLengthThatOption1Keeps) {
    const ReadyGroom ready = make_ready_groom(small_made_groom());
    std::vector<double> option1, position;
    for (const StrandCheck& s : check_of(ready, Blend::option1).strands) {
        option1.push_back(s.length_error);
    }
    for (const StrandCheck& s : check_of(ready, Blend::position).strands) {
        position.push_back(s.length_error);
    }
    // A mean of unit tangents is at most 1 long, and clearly shorter if the guides' waves
    // differ.
    EXPECT_LT(median(position), -0.01);
    EXPECT_LT(std::ranges::max(position), 1e-3);
    EXPECT_NEAR(median(option1), 0, 1e-5);
}

TEST(ReadyGroom, IsTheSameEveryTime) {
    const ReadyGroom a = make_ready_groom(small_made_groom());
    const ReadyGroom b = make_ready_groom(small_made_groom());
    EXPECT_EQ(a.placed.guides.curvatures, b.placed.guides.curvatures);
    EXPECT_EQ(a.binding.roots.positions, b.binding.roots.positions);
    EXPECT_EQ(a.binding.weights, b.binding.weights);
    EXPECT_EQ(a.profiles.count, b.profiles.count);
}

TEST(ReadyGroom, DoesNotChangeGuidesFromACache) {
    TemporaryFolder folder;
    GroomSettings groom = small_made_groom();
    const Guides guides = make_ready_groom(groom).placed.guides;
    write_guide_cache(folder / "guides.h5", {}, {&guides, 1});
    groom.strands_file = folder / "guides.h5";
    groom.strands = 20;  // at the guides' roots, as a cache has no scalp
    const ReadyGroom cached = make_ready_groom(groom);
    EXPECT_EQ(cached.placed.guides.root_positions, guides.root_positions);
    EXPECT_EQ(cached.placed.guides.root_frames, guides.root_frames);
    EXPECT_EQ(cached.placed.guides.segment_lengths, guides.segment_lengths);
    EXPECT_EQ(cached.placed.guides.curvatures, guides.curvatures);
    EXPECT_TRUE(cached.placed.fits.empty());
    EXPECT_EQ(cached.binding.size(), 20u);
    for (std::size_t i = 0; i < 20; ++i) {
        EXPECT_EQ(cached.placed.normals[i], guides.root_frames[i].col(0).cast<float>());
    }
    groom.strands = 21;
    EXPECT_THAT(input_error([&] { make_ready_groom(groom); }), HasSubstr("--scalp"));
}

TEST(ReadyGroom, ScalesFilesToCentimetres) {
    TemporaryFolder folder;
    Strands strands = make_groom({.strands = 30}).strands;
    write_hair(folder / "cm.hair", strands);
    for (Vec3f& p : strands.points) p /= 100;
    write_hair(folder / "m.hair", strands);
    GroomSettings groom = small_made_groom();
    groom.guides.number = 30;
    groom.fit.segments = 8;
    groom.strands = 20;
    groom.strands_file = folder / "cm.hair";
    const ReadyGroom centimetres = make_ready_groom(groom);
    groom.strands_file = folder / "m.hair";
    groom.scene.metres_per_unit = 1;
    const ReadyGroom metres = make_ready_groom(groom);
    ASSERT_EQ(metres.placed.guides.size(), 30u);
    for (std::size_t g = 0; g < 30; ++g) {
        // Coordinates up to 40 cm, rounded twice more by the conversion to metres.
        EXPECT_LT((metres.placed.guides.root_positions[g] -
                   centimetres.placed.guides.root_positions[g])
                      .norm(),
                  1e-5);
        EXPECT_NEAR(guide_length(metres.placed.guides, g),
                    guide_length(centimetres.placed.guides, g), 1e-3);
    }
}

TEST(ReadyGroom, SnapsRootsToTheScalpAndCountsThem) {
    TemporaryFolder folder;
    // Straight strands 0.25 cm above a square, except the first, which stands on it.
    Strands strands;
    for (int i = 0; i < 9; ++i) {
        const float z = i == 0 ? 0 : 0.25f;
        for (int j = 0; j < 5; ++j) {
            strands.points.emplace_back(1 + i % 3, 1 + i / 3, z + float(j));
        }
        strands.first.push_back(std::uint32_t(strands.points.size()));
    }
    write_hair(folder / "a.hair", strands);
    write_bytes(folder / "square.obj",
                "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n");
    GroomSettings groom = small_made_groom();
    groom.strands_file = folder / "a.hair";
    groom.scalp_file = folder / "square.obj";
    groom.strands = 100;
    const ReadyGroom ready = make_ready_groom(groom);
    EXPECT_EQ(ready.placed.report.snapped_roots, 8u);
    EXPECT_NEAR(ready.placed.report.largest_snap, 0.25, 1e-6);
    for (const Vec3& p : ready.placed.guides.root_positions) {
        EXPECT_NEAR(p.z(), 0, 1e-6);
    }
    for (const Vec3f& n : ready.placed.normals) EXPECT_EQ(n, Vec3f::UnitZ());
    EXPECT_TRUE(check_of(ready, Blend::option1).pass());
}

TEST(ReadyGroom, ErrorsNameTheFile) {
    TemporaryFolder folder;
    GroomSettings groom = small_made_groom();
    groom.strands_file = folder / "none.hair";
    EXPECT_THAT(input_error([&] { make_ready_groom(groom); }),
                StartsWith((folder / "none.hair").string()));
    groom = small_made_groom();
    groom.scalp_file = folder / "none.obj";
    EXPECT_THAT(input_error([&] { make_ready_groom(groom); }),
                StartsWith((folder / "none.obj").string()));
}

TEST(ReadyGroom, GrowsARealGroom) {
    const std::filesystem::path data = LANCRET_SOURCE_DIR "/../shared/data";
    if (!std::filesystem::exists(data / "sintel.hair")) {
        GTEST_SKIP() << "no groom files in " << data;
    }
    GroomSettings groom;
    groom.name = "sintel";
    groom.strands_file = data / "sintel.hair";
    groom.guides.number = 150;
    groom.strands = 1000;
    const ReadyGroom ready = make_ready_groom(groom);
    std::vector<double> rms;
    for (const FitReport& fit : ready.placed.fits) {
        rms.push_back(fit.rms / fit.length);
    }
    ASSERT_EQ(rms.size(), 150u);
    EXPECT_LT(median(rms), 0.01);
    const CheckReport report = check_of(ready, Blend::option1);
    for (const StrandCheck& s : report.strands) {
        EXPECT_LE(std::abs(s.length_error), 1e-5) << s.strand;
        EXPECT_LE(s.orthogonality, 1e-6) << s.strand;
        EXPECT_TRUE(s.finite && s.tip_within_reach && s.inside_hull) << s.strand;
    }
    EXPECT_TRUE(report.pass());
}

}  // namespace
}  // namespace lancret
