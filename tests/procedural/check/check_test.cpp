#include "procedural/check/check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "procedural/check/report.h"
#include "procedural/check/strand.h"
#include "tests/procedural/made_hair.h"

namespace lancret {
namespace {

using test::MadeHair;

constexpr std::size_t kStrand = 37;  ///< the strand that the tests break
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// 120 children of gentle guides with many intervals, and functions that break one.
struct Check : testing::Test {
    MadeHair hair{120, 32, 1, 4, 4, 0.1};
    Curves curves = expand(hair.binding, hair.profiles, {.blend = Blend::option1});
    Blend blend = Blend::option1;

    CheckReport report() const {
        return check_strands({hair.binding,
                              hair.standing.guides,
                              hair.classed(blend),
                              curves,
                              {.blend = blend}});
    }
    std::span<Point4f> points() {
        return curves.points.span().subspan(kStrand * curves.points_of(0),
                                            curves.points_of(0));
    }
    void move(std::size_t first, std::size_t count, const Vec3f& by) {
        for (Point4f& p : points().subspan(first, count)) {
            p = {p.x + by.x(), p.y + by.y(), p.z + by.z(), p.w};
        }
    }
    /// Expects that kStrand fails, and only kStrand, and that it is reported as the
    /// worst.
    static void expect_only_ours_fails(const CheckReport& report) {
        EXPECT_FALSE(report.pass());
        for (const StrandCheck& s : report.strands) {
            EXPECT_EQ(report.passes(s), s.strand != kStrand) << s.strand;
        }
        EXPECT_EQ(report.worst(1).at(0).strand, kStrand);
        const nlohmann::json json = check_json(report);
        EXPECT_EQ(json["pass"], false);
        EXPECT_EQ(json["failed"], 1);
        EXPECT_EQ(json["worst"][0]["strand"], kStrand);
        EXPECT_EQ(json["worst"][0]["ok"], false);
        EXPECT_THAT(check_table(report), testing::HasSubstr("\nFAIL: 1 of 120 "));
    }
};

TEST_F(Check, PassesCorrectStrands) {
    const CheckReport found = report();
    EXPECT_TRUE(found.pass());
    ASSERT_EQ(found.strands.size(), 120u);
    for (std::size_t i = 0; i < 120; ++i) EXPECT_EQ(found.strands[i].strand, i);
    const nlohmann::json json = check_json(found);
    EXPECT_EQ(json["pass"], true);
    EXPECT_EQ(json["failed"], 0);
    EXPECT_EQ(json["strands"], 120);
    EXPECT_THAT(check_table(found), testing::HasSubstr("\nPASS: all 120 strands"));
}

TEST_F(Check, FindsALengthThatDiffersFromTheGuides) {
    hair.binding.lengths[kStrand] *= 1.001f;
    curves = expand(hair.binding, hair.profiles, {.blend = Blend::option1});
    const CheckReport found = report();
    expect_only_ours_fails(found);
    // Up to single precision.
    EXPECT_NEAR(found.strands[kStrand].length_error, 1e-3, 1e-5);
    EXPECT_NEAR(found.strands[kStrand].emitted_length_error, 1e-3, 1e-4);
    // The strand itself is longer, so the curve still follows it.
    EXPECT_LT(found.strands[kStrand].distance, 0.01);
    EXPECT_NEAR(check_json(found)["length"]["max_relative_error"], 1e-3, 1e-5);
}

TEST_F(Check, FindsACurveLongerThanItsStrand) {
    const float before = report().strands[kStrand].emitted_length_error;
    const Vec3f root = hair.binding.roots.positions[kStrand];
    for (Point4f& p : points()) {
        const Vec3f x = root + 1.05f * (p.xyz() - root);
        p = {x.x(), x.y(), x.z(), p.w};
    }
    const CheckReport found = report();
    expect_only_ours_fails(found);
    EXPECT_NEAR(found.strands[kStrand].emitted_length_error, 0.05 + 1.05 * before, 1e-5);
    EXPECT_NEAR(found.strands[kStrand].length_error, 0, 1e-5);
}

TEST_F(Check, FindsAMovedControlPoint) {
    const StrandCheck before = report().strands[kStrand];
    // Across the strand, at its middle.
    const Vec3 tangent = emitted_strand(curves, kStrand).derivative(16, 0);
    move(17, 1, 0.3f * tangent.unitOrthogonal().cast<float>());
    const CheckReport found = report();
    expect_only_ours_fails(found);
    // A control point moves the curve by at most 4/6 of its own motion, and at t = 1/4 by
    // (4 - 6 t^2 + 3 t^3) / 6 = 0.61 of the 0.3 cm.
    EXPECT_NEAR(found.strands[kStrand].distance, 0.61 * 0.3, 0.02);
    // A bump makes the curve longer.
    EXPECT_GT(found.strands[kStrand].emitted_length_error,
              before.emitted_length_error + 1e-4);
    EXPECT_EQ(found.strands[kStrand].root_distance, before.root_distance);
}

TEST_F(Check, FindsAStrandOffItsRoot) {
    move(0, curves.points_of(0), Vec3f(0, 0.01f, 0));
    const CheckReport found = report();
    expect_only_ours_fails(found);
    EXPECT_NEAR(found.strands[kStrand].root_distance, 0.01, 1e-5);
}

TEST_F(Check, FindsATipOutOfReach) {
    // The last segment ends at the mean (1, 4, 1) / 6 of the last three control points:
    // it moves with them along the chord, to 1.001 of the strand's length from its root.
    // The check allows 1.0001 of it and 0.001 cm.
    const Vec3f root = hair.binding.roots.positions[kStrand];
    const Vec3f chord =
        emitted_strand(curves, kStrand).position(31, 1).cast<float>() - root;
    const float reach = hair.binding.lengths[kStrand] + 0.001f;
    const auto move_tip_to = [&](float distance) {
        move(curves.points_of(0) - 3, 3, (distance / chord.norm() - 1) * chord);
    };
    const std::vector<Point4f> before(points().begin(), points().end());
    move_tip_to(0.9999f * reach);
    EXPECT_TRUE(report().strands[kStrand].tip_within_reach);
    std::ranges::copy(before, points().begin());
    move_tip_to(1.001f * reach);
    const CheckReport found = report();
    expect_only_ours_fails(found);
    EXPECT_FALSE(found.strands[kStrand].tip_within_reach);
    EXPECT_EQ(check_json(found)["out_of_reach"], 1);
}

TEST_F(Check, FindsNaNInAControlPoint) {
    points()[5].y = kNaN;
    const CheckReport found = report();
    EXPECT_FALSE(found.strands[kStrand].finite);
    expect_only_ours_fails(found);
    const nlohmann::json json = check_json(found);
    EXPECT_EQ(json["non_finite"], 1);
    EXPECT_TRUE(json["emitted_length"]["max_relative_error"].is_null());
    EXPECT_TRUE(json["worst"][0]["emitted_length"].is_null());
    // The text remains valid JSON.
    EXPECT_NO_THROW(nlohmann::json::parse(json.dump()));
}

TEST_F(Check, FindsNaNInARadiusAndATangent) {
    points()[5].w = kNaN;
    EXPECT_FALSE(report().strands[kStrand].finite);
    expect_only_ours_fails(report());
    curves = expand(hair.binding, hair.profiles,
                    {.blend = Blend::option1, .basis = CurveBasis::hermite});
    EXPECT_TRUE(report().pass());
    curves.tangents[kStrand * curves.points_of(0) + 4].w = kNaN;
    expect_only_ours_fails(report());
}

TEST_F(Check, FindsNaNInSynthesis) {
    hair.binding.lengths[kStrand] = kNaN;
    const CheckReport found = report();
    EXPECT_FALSE(found.strands[kStrand].finite);
    EXPECT_FALSE(found.pass());
}

TEST(CheckHull, FindsCurvatureOutsideThatOfTheGuides) {
    // One guide per child, and one guide whose profile has 1.5 times its curvature.
    MadeHair hair(200, 8, 2, 1);
    const std::uint32_t guide = hair.binding.guides[0];
    for (int i = 0; i < 8; ++i) hair.profiles.intervals[guide * 8 + i].kappa *= 1.5f;
    for (const Blend blend : {Blend::option1, Blend::position}) {
        const Curves curves = expand(hair.binding, hair.profiles, {.blend = blend});
        const CheckReport found = check_strands({hair.binding,
                                                 hair.standing.guides,
                                                 hair.classed(blend),
                                                 curves,
                                                 {.blend = blend}});
        EXPECT_EQ(found.hull_applies, blend == Blend::option1);
        if (blend == Blend::position) continue;
        std::size_t outside = 0;
        for (std::size_t i = 0; i < 200; ++i) {
            EXPECT_EQ(found.strands[i].inside_hull, hair.binding.guides[i] != guide);
            outside += !found.strands[i].inside_hull;
            if (!found.strands[i].inside_hull) {
                EXPECT_FALSE(found.passes(found.strands[i]));
            }
        }
        EXPECT_GT(outside, 0u);
        EXPECT_EQ(check_json(found)["hull"]["outside"], outside);
    }
}

TEST(CheckHull, FindsTorsionOutsideThatOfTheGuides) {
    MadeHair hair(100, 8, 3, 1);
    const std::uint32_t guide = hair.binding.guides[0];
    hair.profiles.intervals[guide * 8 + 3].tau += 0.1f;
    const Curves curves = expand(hair.binding, hair.profiles, {.blend = Blend::option1});
    const CheckReport found = check_strands({hair.binding,
                                             hair.standing.guides,
                                             hair.classed(Blend::option1),
                                             curves,
                                             {.blend = Blend::option1}});
    for (std::size_t i = 0; i < 100; ++i) {
        EXPECT_EQ(found.strands[i].inside_hull, hair.binding.guides[i] != guide);
    }
}

TEST(CheckReport, EachToleranceAppliesByItself) {
    const CheckReport report{.tolerances = {}, .hull_applies = true, .strands = {}};
    const CheckTolerances& t = report.tolerances;
    EXPECT_TRUE(report.passes({}));
    const std::pair<float StrandCheck::*, double> figures[] = {
        {&StrandCheck::orthogonality, t.orthogonality},
        {&StrandCheck::length_error, t.length},
        {&StrandCheck::emitted_length_error, t.emitted_length},
        {&StrandCheck::distance, t.distance},
        {&StrandCheck::root_distance, t.root}};
    for (const auto& [figure, tolerance] : figures) {
        StrandCheck strand;
        strand.*figure = float(0.99 * tolerance);
        EXPECT_TRUE(report.passes(strand));
        strand.*figure = float(1.01 * tolerance);
        EXPECT_FALSE(report.passes(strand));
        // Even if later figures keep their tolerances.
        strand.*figure = kNaN;
        EXPECT_FALSE(report.passes(strand));
    }
    StrandCheck shorter;
    shorter.length_error = float(-2 * t.length);
    EXPECT_FALSE(report.passes(shorter));
}

TEST(CheckReport, FlagsFailAStrand) {
    CheckReport report;
    EXPECT_FALSE(report.passes({.finite = false}));
    EXPECT_FALSE(report.passes({.tip_within_reach = false}));
    EXPECT_FALSE(report.passes({.inside_hull = false}));
    report.hull_applies = false;
    EXPECT_TRUE(report.passes({.inside_hull = false}));
}

TEST(CheckReport, WorstIsTheLargestShareOfATolerance) {
    CheckReport report;
    report.strands.resize(4);
    for (std::uint32_t i = 0; i < 4; ++i) report.strands[i].strand = i;
    report.strands[1].length_error = float(-0.5 * report.tolerances.length);
    report.strands[2].distance = float(0.7 * report.tolerances.distance);
    report.strands[3].tip_within_reach = false;
    const auto worst = report.worst(10);
    ASSERT_EQ(worst.size(), 4u);
    EXPECT_EQ(worst[0].strand, 3u);
    EXPECT_EQ(worst[1].strand, 2u);
    EXPECT_EQ(worst[2].strand, 1u);
    EXPECT_EQ(report.worst(2).size(), 2u);
}

TEST(CheckReport, HistogramCountsDecadesOfTheLengthError) {
    CheckReport report;
    for (const float error : {0.0f, 5e-9f, 2e-8f, -3e-6f, 0.5f, 7.0f, kNaN}) {
        report.strands.push_back({.length_error = error});
    }
    const std::vector<int> expected = {2, 1, 0, 1, 0, 0, 0, 0, 1, 2};
    EXPECT_EQ(check_json(report)["length"]["histogram"], nlohmann::json(expected));
}

TEST(CheckHull, SkipsIntervalsThatContainAJoint) {
    // 26 intervals over 4 segments: those across a joint have no single curvature.
    MadeHair hair{120, 26, 1, 4, 4, 0.1};
    const Curves curves = expand(hair.binding, hair.profiles, {.blend = Blend::option1});
    const CheckReport report = check_strands({hair.binding,
                                              hair.standing.guides,
                                              hair.classed(Blend::option1),
                                              curves,
                                              {.blend = Blend::option1}});
    for (const StrandCheck& s : report.strands) EXPECT_TRUE(s.inside_hull) << s.strand;
}

TEST(CheckHull, FindsAStrandThatBendsMoreThanItsGuides) {
    // The strands are made from one set of guides and compared with straighter ones.
    MadeHair hair{120, 32, 1, 4, 4, 0.1};
    const Curves curves = expand(hair.binding, hair.profiles, {.blend = Blend::option1});
    Guides straighter = hair.standing.guides;
    for (Vec3& u : straighter.curvatures) u *= 0.5;
    const CheckReport report = check_strands({hair.binding,
                                              straighter,
                                              hair.classed(Blend::option1),
                                              curves,
                                              {.blend = Blend::option1}});
    std::size_t outside = 0;
    for (const StrandCheck& s : report.strands) outside += !s.inside_hull;
    EXPECT_GT(outside, report.strands.size() / 2);
}

}  // namespace
}  // namespace lancret
