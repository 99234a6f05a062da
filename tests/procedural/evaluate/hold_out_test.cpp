#include "procedural/evaluate/hold_out.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cstring>
#include <set>

#include "procedural/evaluate/evaluation.h"
#include "tests/guides/base/temporary_folder.h"
#include "tests/guides/mesh/meshes.h"
#include "tests/procedural/made_strands.h"

namespace lancret {
namespace {

using test::curly_strands;

TEST(HoldOut, EveryStrandIsAGuideOrIsPredicted) {
    const Strands strands = curly_strands(120, 1);
    const HoldOut holdout = hold_out(strands, nullptr, {.guides = {.share = 0.1}}, "g");
    EXPECT_EQ(holdout.guide_strands.size(), 12u);
    EXPECT_EQ(holdout.guides.size(), 12u);
    EXPECT_EQ(holdout.binding.size(), 108u);
    std::set<std::uint32_t> all(holdout.guide_strands.begin(),
                                holdout.guide_strands.end());
    all.insert(holdout.child_strands.begin(), holdout.child_strands.end());
    EXPECT_EQ(all.size(), 120u);
}

TEST(HoldOut, ChildrenStandOnTheirOwnRoots) {
    const Strands strands = curly_strands(60, 2);
    const HoldOut holdout = hold_out(strands, nullptr, {.guides = {.number = 7}}, "g");
    ASSERT_EQ(holdout.guides.size(), 7u);
    for (std::size_t c = 0; c < holdout.binding.size(); ++c) {
        const Vec3f root = strands.strand(holdout.child_strands[c])[0];
        EXPECT_EQ(holdout.binding.roots.positions[c], root);
        EXPECT_EQ(holdout.truth.strand(c)[0], root.cast<double>());
    }
}

/// `strands` with each of `which` bent, lengthened and rotated about its root.
Strands with_others(Strands strands, std::span<const std::uint32_t> which) {
    for (const std::uint32_t i : which) {
        const Vec3f root = strands.strand(i)[0];
        for (std::uint32_t p = strands.first[i] + 1; p < strands.first[i + 1]; ++p) {
            const Vec3f off = strands.points[p] - root;
            strands.points[p] =
                root + 1.7f * Vec3f(off.y() + 0.3f * off.squaredNorm(), off.z(), off.x());
        }
    }
    return strands;
}

TEST(HoldOut, PredictionsUseOnlyTheRootOfAHeldOutStrand) {
    const Strands strands = curly_strands(150, 3);
    const Scalp scalp = make_scalp(square_mesh(10, 4));
    for (const Scalp* surface : {static_cast<const Scalp*>(nullptr), &scalp}) {
        const HoldOutSettings settings{.guides = {.share = 0.1}};
        const HoldOut holdout = hold_out(strands, surface, settings, "g");
        const HoldOut other =
            hold_out(with_others(strands, holdout.child_strands), surface, settings, "g");
        ASSERT_EQ(holdout.guide_strands, other.guide_strands);
        // The truth has changed.
        ASSERT_GT((holdout.truth.points.back() - other.truth.points.back()).norm(), 1);
        EXPECT_EQ(holdout.guides.segments, other.guides.segments);
        EXPECT_EQ(holdout.binding.lengths, other.binding.lengths);
        const int n = evaluation_intervals(holdout.guides);
        ASSERT_EQ(n, evaluation_intervals(other.guides));
        const auto profiles = guide_profiles<float>(holdout.guides, n);
        const auto other_profiles = guide_profiles<float>(other.guides, n);
        for (const BlendTraits& entry : blends()) {
            const Prediction a = predict(holdout, profiles, entry.blend);
            const Prediction b = predict(other, other_profiles, entry.blend);
            EXPECT_EQ(std::memcmp(a.strands.points.data(), b.strands.points.data(),
                                  a.strands.points.size() * sizeof(Vec3)),
                      0)
                << entry.name;
        }
    }
}

TEST(HoldOut, WithoutAScalpNothingIsRotatedAndFacingHasNoEffect) {
    // Half the guides point downward: with facing they would have no weight.
    Strands strands = curly_strands(100, 4);
    for (std::size_t i = 0; i < strands.size(); i += 2) {
        for (std::uint32_t p = strands.first[i]; p < strands.first[i + 1]; ++p) {
            strands.points[p].z() *= -1;
        }
    }
    const HoldOut holdout = hold_out(strands, nullptr, {.guides = {.share = 0.2}}, "g");
    EXPECT_EQ(holdout.binding.report.no_facing_guide, 0u);
    const auto& normals = holdout.binding.roots.normals;
    EXPECT_TRUE(
        std::ranges::all_of(normals, [](auto& n) { return n == Vec3f::UnitZ(); }));
}

TEST(HoldOut, SampledGuidesKeepTheirShape) {
    for (const double turns : {0.0, 2.0, 8.0}) {
        const HoldOut holdout = hold_out(curly_strands(80, 5, turns), nullptr,
                                         {.guides = {.share = 0.2}}, "g");
        EXPECT_FALSE(holdout.fit.fitted);
        // The limits of make_guides for fewer than the maximum of 128 segments.
        if (holdout.guides.segments < 128) {
            EXPECT_LE(holdout.fit.curvature.w1, 0.005) << turns;
            EXPECT_LE(holdout.fit.rms.p95, 0.002) << turns;
        }
        EXPECT_LE(holdout.fit.rms.p95, 0.002) << turns;
    }
}

TEST(HoldOut, RequestedSegmentsAreFitted) {
    const HoldOut holdout = hold_out(curly_strands(40, 6, 1), nullptr,
                                     {.guides = {.share = 0.2}, .segments = 12}, "g");
    EXPECT_TRUE(holdout.fit.fitted);
    EXPECT_EQ(holdout.guides.segments, 12);
}

TEST(HoldOut, AGroomWithNothingToPredictIsRefused) {
    const Strands strands = curly_strands(10, 7);
    EXPECT_NE(input_error([&] {
                  hold_out(strands, nullptr, {.guides = {.number = 10}}, "g.hair");
              }).find("g.hair: 10 of its 10 strands"),
              std::string::npos);
    const Strands one = curly_strands(1, 7);
    EXPECT_NE(input_error([&] { hold_out(one, nullptr, {}, "g.hair"); }), "");
}

TEST(HoldOut, StrandsOfZeroLengthAreIgnoredAndCounted) {
    Strands strands = curly_strands(30, 8);
    for (std::uint32_t p = strands.first[3]; p < strands.first[4]; ++p) {
        strands.points[p] = Vec3f(1, 1, 0);
    }
    for (std::uint32_t p = strands.first[5]; p < strands.first[6]; ++p) {
        strands.points[p] *= 1e-20f;
    }
    const HoldOut holdout = hold_out(strands, nullptr, {.guides = {.number = 5}}, "g");
    EXPECT_EQ(holdout.flat_strands, 2u);
    EXPECT_EQ(holdout.guides.size() + holdout.binding.size(), 28u);
    EXPECT_FALSE(std::ranges::binary_search(holdout.child_strands, 3u));
}

}  // namespace
}  // namespace lancret
