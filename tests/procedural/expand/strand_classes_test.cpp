// Interval counts adapted to the children of each guide.

#include "procedural/expand/strand_classes.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cstring>
#include <map>

#include "procedural/chunk/chunked_groom.h"
#include "procedural/expand/child_strands.h"
#include "procedural/expand/class_choice.h"
#include "tests/procedural/made_hair.h"
#include "tests/procedural/small_groom.h"

namespace lancret {
namespace {

/// Guides on the square [0, 10]^2: straight for x < 5, helices of 1 cm wavelength for x
/// > 5.
test::StandingGuides half_curled() {
    test::StandingGuides out;
    for (int i = 0; i < 36; ++i) {
        const double x = 10 * (i % 6 + 0.5) / 6, y = 10 * (i / 6 + 0.5) / 6;
        const Vec3 u = x < 5 ? Vec3::Zero() : Vec3(3, 0, 3 + 0.1 * i);
        Mat3 up;
        up << Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY();
        test::add_guide(out.guides, {u, u, u, u}, 8, up, {x, y, 0});
        out.normals.push_back(Vec3f::UnitZ());
    }
    return out;
}

struct HalfCurled {
    static constexpr int kFinest = 64;
    static constexpr double kTolerance = 0.02;

    test::StandingGuides standing = half_curled();
    ExpandSettings settings;
    Binding unsorted =
        bind(test::plane_roots(800, 3), standing.guides, standing.normals, {});
    StrandClasses classes = chosen(unsorted);
    Binding binding = in_class_order(unsorted, classes);
    ClassedGuides guides =
        classed_guides(standing.guides, classes, standing.normals, settings.blend);

    explicit HalfCurled(const ExpandSettings& expand = {}) : settings(expand) {}

    StrandClasses chosen(const Binding& sample) const {
        StrandClasses all = coarsest_classes(standing.guides, kFinest);
        refine_classes(all, sample, standing.guides, kTolerance, settings);
        return used_classes(all);
    }
    int count_of(std::size_t child) const {
        return classes.counts[classes.of(binding, child)];
    }
};

TEST(StrandClasses, AreMultiplesOfTheSegmentsThenHalves) {
    const Guides guides = half_curled().guides;
    EXPECT_EQ(coarsest_classes(guides, 64).counts,
              (std::vector<int>{64, 60, 56, 52, 48, 44, 40, 36, 32, 28, 24, 20, 16, 12, 8,
                                4, 2, 1}));
    EXPECT_EQ(coarsest_classes(guides, 1).counts, std::vector<int>{1});
    EXPECT_LE(coarsest_classes(guides, 1000).size(), kMaxClasses);
}

TEST(StrandClasses, StraightStrandsDoNotPayForCurls) {
    const HalfCurled hair;
    std::size_t straight = 0;
    for (std::size_t i = 0; i < hair.binding.size(); ++i) {
        const float x = hair.binding.roots.positions[i].x();
        // At least a column of guides away from the border, all guides are alike. Curls
        // of at least 35 radians need more than 11 intervals, at less than half a turn
        // each.
        EXPECT_TRUE(x > 2 || hair.count_of(i) == 1) << i;
        EXPECT_TRUE(x < 8 || hair.count_of(i) > 11) << i;
        straight += hair.count_of(i) == 1;
    }
    EXPECT_GT(straight, hair.binding.size() / 5);
    const Curves curves = expand(hair.binding, hair.guides, {});
    EXPECT_LT(double(curves.points.size()), 0.75 * double(hair.binding.size() * 67));
}

TEST(StrandClasses, KeepTheToleranceOfMeasuredChildren) {
    for (const Blend blend : {Blend::detail, Blend::option1, Blend::nearest}) {
        for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
            const HalfCurled hair({.blend = blend, .basis = basis});
            const auto finest =
                guide_profiles<float>(hair.standing.guides, HalfCurled::kFinest);
            for (std::size_t i = 0; i < hair.binding.size(); ++i) {
                const auto c = hair.classes.of(hair.binding, i);
                if (hair.classes.counts[c] == HalfCurled::kFinest) continue;
                EXPECT_LE(adapted_distance(hair.binding, finest, hair.guides.profiles[c],
                                           i, hair.settings),
                          0.6001 * HalfCurled::kTolerance)
                    << i;
            }
        }
    }
}

TEST(StrandClasses, AreTheSameForAnyNumberOfThreads) {
    const HalfCurled hair;
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const StrandClasses alone = hair.chosen(hair.unsorted);
    EXPECT_EQ(alone.counts, hair.classes.counts);
    EXPECT_EQ(alone.of_guide, hair.classes.of_guide);
}

TEST(StrandClasses, OfAGuideThatLeadsNoChildAreThoseOfItsCopy) {
    const HalfCurled hair;
    const StrandClasses found = hair.chosen(picked(hair.unsorted, {}));
    for (std::size_t g = 0; g < hair.standing.guides.size(); ++g) {
        const bool straight = hair.standing.guides.root_positions[g].x() < 5;
        EXPECT_EQ(found.counts[found.of_guide[g]] == 1, straight) << g;
    }
}

TEST(StrandClasses, AreFinerForATimeAtWhichTheyCurl) {
    const HalfCurled hair;
    Guides curled = hair.standing.guides;
    for (Vec3& u : curled.curvatures) u = Vec3(3, 0, 4);
    StrandClasses all = coarsest_classes(curled, HalfCurled::kFinest);
    refine_classes(all, hair.unsorted, hair.standing.guides, HalfCurled::kTolerance, {});
    const std::vector<std::uint8_t> before = all.of_guide;
    refine_classes(all, hair.unsorted, curled, HalfCurled::kTolerance, {});
    for (std::size_t g = 0; g < before.size(); ++g) {
        EXPECT_LE(all.of_guide[g], before[g]);
        EXPECT_GT(all.counts[all.of_guide[g]], 11);
    }
}

TEST(StrandClasses, AStrandHasTheBitsOfOneClass) {
    for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
        for (const std::uint32_t grain : {256u, 7u}) {
            const HalfCurled hair({.basis = basis, .grain = grain});
            const Curves curves = expand(hair.binding, hair.guides, hair.settings);
            ASSERT_EQ(curves.strands, 800u);
            ASSERT_GT(curves.classes.size(), 2u);
            std::vector<Curves> alike;
            for (const auto& profiles : hair.guides.profiles) {
                alike.push_back(expand(hair.unsorted, profiles, hair.settings));
            }
            std::vector<int> seen(800, 0);
            for (std::uint32_t i = 0; i < curves.strands; ++i) {
                const std::uint32_t id = curves.id_of(i);
                ++seen[id];
                const Curves& expected = alike[hair.classes.of(hair.binding, i)];
                const auto same = [&](const auto& buffer, const auto& other) {
                    const auto a = curves.of_strand(buffer, i),
                               b = expected.of_strand(other, id);
                    return a.size() == b.size() &&
                           std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
                };
                ASSERT_TRUE(same(curves.points, expected.points)) << i;
                ASSERT_TRUE(same(curves.tangents, expected.tangents)) << i;
            }
            EXPECT_TRUE(std::ranges::all_of(seen, [](int n) { return n == 1; }));
        }
    }
}

TEST(StrandClasses, SegmentsAreNumberedConsecutively) {
    const HalfCurled hair;
    const Curves curves = expand(hair.binding, hair.guides, {});
    std::uint32_t segment = 0, point = 0;
    for (std::uint32_t i = 0; i < curves.strands; ++i) {
        const auto n = std::uint32_t(hair.count_of(i));
        ASSERT_EQ(curves.first_point(i), point);
        ASSERT_EQ(curves.points_of(i), n + 3);
        for (std::uint32_t j = 0; j < n; ++j, ++segment) {
            const SegmentPlace place = curves.place_of(segment);
            ASSERT_EQ(place.strand, i);
            ASSERT_EQ(place.in_strand, j);
            ASSERT_EQ(place.of, n);
            ASSERT_EQ(place.point, point + j);
            ASSERT_EQ(curves.segments[segment], point + j);
        }
        point += n + 3;
    }
    EXPECT_EQ(curves.segments.size(), segment);
    EXPECT_EQ(curves.points.size(), point);
}

TEST(StrandClasses, ChildrenInAnotherOrderThrow) {
    const HalfCurled hair;
    EXPECT_THROW(expand(hair.unsorted, hair.guides, {}), std::invalid_argument);
    EXPECT_THROW(Curves().add_class(1u << 30, 4), std::invalid_argument);
}

TEST(StrandClasses, ExportedStrandsAreOrderedById) {
    const HalfCurled hair;
    const Strands strands = child_strands(hair.binding, hair.guides, {});
    ASSERT_EQ(strands.size(), 800u);
    ASSERT_EQ(strands.thickness.size(), strands.points.size());
    for (std::size_t i = 0; i < strands.size(); ++i) {
        const auto c = hair.classes.of(hair.unsorted, i);
        ASSERT_EQ(strands.strand(i).size(), std::size_t(hair.classes.counts[c]) + 1);
        EXPECT_EQ(strands.strand(i)[0], hair.unsorted.roots.positions[i]);
    }
}

GroomSettings groom_of_classes() {
    return test::small_groom({.made = 40, .guides = 40, .segments = 6, .strands = 1000});
}

TEST(StrandClasses, AreTheSameInEveryChunkAndAtEveryDensity) {
    const ReadyGroom whole = make_ready_groom(groom_of_classes());
    ASSERT_GT(whole.classes.size(), 1u);
    GroomSettings thin = groom_of_classes();
    thin.density = 0.3;
    EXPECT_EQ(make_ready_groom(thin).classes.of_guide, whole.classes.of_guide);
    const ChunkedGroom chunked = make_chunked_groom(thin, 64);
    EXPECT_EQ(chunked.ready.classes.of_guide, whole.classes.of_guide);
    EXPECT_EQ(chunked.ready.classes.counts, whole.classes.counts);
}

TEST(StrandClasses, AreOneIfAGroomFixesIntervalsOrHasFaces) {
    GroomSettings fixed = groom_of_classes(), alike = fixed, faces = fixed;
    fixed.intervals = 9;
    alike.adapt = false;
    faces.expand.shape = CurveShape::ribbon;
    EXPECT_EQ(make_ready_groom(fixed).classes.counts, std::vector<int>{9});
    for (const GroomSettings& groom : {alike, faces}) {
        const ReadyGroom ready = make_ready_groom(groom);
        EXPECT_EQ(ready.classes.counts, std::vector<int>{ready.profiles.count});
    }
}

}  // namespace
}  // namespace lancret
