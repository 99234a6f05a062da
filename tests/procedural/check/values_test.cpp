#include "procedural/check/values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/procedural/made_hair.h"

namespace lancret {
namespace {

using test::MadeHair;

/// 80 children of random guides, and their check.
struct Checked {
    MadeHair hair{80, 16, 3};
    Blend blend = Blend::detail;

    CheckReport report() const {
        const Curves curves = expand(hair.binding, hair.profiles, {.blend = blend});
        return check_strands({hair.binding,
                              hair.standing.guides,
                              hair.classed(blend),
                              curves,
                              {.blend = blend}});
    }
};

TEST(CheckValues, LengthErrorsAreTheReports) {
    Checked made;
    made.hair.binding.lengths[7] *= 1.001f;
    const CheckReport report = made.report();
    const StrandValues values = length_error_values(report);
    ASSERT_EQ(values.strands(), 80u);
    for (std::uint32_t i = 0; i < 80; ++i) {
        EXPECT_EQ(values.at(i, 0.3f), std::abs(report.strands[i].length_error)) << i;
        EXPECT_EQ(values.at(i, 0) > report.tolerances.length, i == 7) << i;
    }
}

TEST(CheckValues, TheLargestOrthogonalityOfAStrandIsTheReports) {
    const Checked made;
    const CheckReport report = made.report();
    const StrandValues values = orthogonality_values(
        made.hair.binding, made.hair.classed(made.blend), made.blend);
    ASSERT_EQ(values.strands(), 80u);
    for (std::size_t i = 0; i < 80; ++i) {
        const auto along = values.of(i);
        ASSERT_EQ(along.size(), 17u);
        EXPECT_EQ(*std::ranges::max_element(along), report.strands[i].orthogonality) << i;
    }
}

TEST(CheckValues, CurvatureAndTorsionAreThoseOfAHelix) {
    // All guides are the same helix, and so are their children at any weights. An entry
    // of a frame is accurate to 5e-7 and a rotation over ds to 2e-6, twice that over both
    // ends: the allowance of the check for single precision.
    Guides guides;
    std::vector<Vec3f> normals;
    const Mat3 frame = (Mat3() << Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY()).finished();
    for (int g = 0; g < 6; ++g) {
        test::add_guide(guides, {Vec3(-0.2, 0, 0.5)}, 10, frame, Vec3(g, 0, 0));
        normals.push_back(Vec3f::UnitZ());
    }
    const Binding binding = bind(test::plane_roots(20, 1), guides, normals, {});
    const auto profiles = guide_profiles<float>(guides, 20);
    const float tolerance = 4e-6f / 0.5f;
    for (const Blend blend : {Blend::detail, Blend::option1, Blend::nearest}) {
        ASSERT_TRUE(traits_of(blend).has_torsion);
        const ClassedGuides classed =
            test::one_class(profiles, binding.guide_normals, blend);
        const StrandValues kappa = curvature_values(binding, classed, blend);
        const StrandValues tau = torsion_values(binding, classed, blend);
        ASSERT_EQ(kappa.values.size(), 400u);
        ASSERT_EQ(tau.values.size(), 400u);
        for (std::size_t i = 0; i < 400; ++i) {
            EXPECT_NEAR(kappa.values[i], 0.5f, tolerance) << blend_name(blend) << i;
            EXPECT_NEAR(tau.values[i], -0.2f, tolerance) << blend_name(blend) << i;
        }
    }
}

TEST(CheckValues, AreLinearBetweenPlacesAndConstantInIntervals) {
    const StrandValues intervals{false, {1, 2, 5, 7}, {0, 2, 4}};
    EXPECT_EQ(intervals.at(1, 0), 5);
    EXPECT_EQ(intervals.at(1, 0.49f), 5);
    EXPECT_EQ(intervals.at(1, 0.5f), 7);
    EXPECT_EQ(intervals.at(1, 1), 7);
    const StrandValues places{true, {0, 0, 0, 1, 2, 6}, {0, 3, 6}};
    EXPECT_EQ(places.at(1, 0), 1);
    EXPECT_EQ(places.at(1, 0.25f), 1.5f);
    EXPECT_EQ(places.at(1, 0.5f), 2);
    EXPECT_EQ(places.at(1, 0.75f), 4);
    EXPECT_EQ(places.at(1, 1), 6);
}

TEST(CheckValues, NonFiniteValuesAreTheLargest) {
    CheckReport report;
    report.strands.resize(2);
    report.strands[0].length_error = std::numeric_limits<float>::quiet_NaN();
    report.strands[1].length_error = -std::numeric_limits<float>::infinity();
    for (const float value : length_error_values(report).values) {
        EXPECT_EQ(value, std::numeric_limits<float>::max());
    }
}

}  // namespace
}  // namespace lancret
