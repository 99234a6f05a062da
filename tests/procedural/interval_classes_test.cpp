#include "procedural/interval_classes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "procedural/child_strands.h"
#include "tests/procedural/made_hair.h"

namespace lancret {
namespace {

/// Guides on the square [0, 10]^2: straight for x < 5, helices of 1 cm wavelength beyond.
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
    test::StandingGuides standing = half_curled();
    Binding binding =
        bind(test::plane_roots(800, 3), standing.guides, standing.normals, {});
    static constexpr int kFinest = 64;
    static constexpr double kTolerance = 0.02;

    IntervalClasses classes = interval_classes(standing.guides, kFinest);

    std::vector<std::uint8_t> of_child(const ExpandSettings& settings) const {
        return child_classes(binding, classes, kTolerance, settings);
    }
};

TEST(IntervalClasses, AreMultiplesOfTheSegmentsThenHalves) {
    const HalfCurled hair;
    EXPECT_EQ(hair.classes.counts, (std::vector<int>{64, 60, 56, 52, 48, 44, 40, 36, 32,
                                                     28, 24, 20, 16, 12, 8, 4, 2, 1}));
    EXPECT_EQ(interval_classes(hair.standing.guides, 1).counts, std::vector<int>{1});
}

TEST(IntervalClasses, StraightStrandsDoNotPayForCurls) {
    const HalfCurled hair;
    const auto of_child = hair.of_child({});
    std::size_t points = 0, straight = 0;
    for (std::size_t i = 0; i < hair.binding.size(); ++i) {
        const int count = hair.classes.counts[of_child[i]];
        const float x = hair.binding.roots.positions[i].x();
        // A column of guides and more away from the border, all guides are alike. Curls
        // of 35 radians and more cannot be drawn in intervals of half a turn.
        EXPECT_TRUE(x > 2 || count == 1) << i;
        EXPECT_TRUE(x < 8 || count > 11) << i;
        straight += count == 1;
        points += std::size_t(count) + 3;
    }
    EXPECT_GT(straight, hair.binding.size() / 5);
    EXPECT_LT(double(points), 0.75 * double(hair.binding.size() * 67));
}

TEST(IntervalClasses, EveryChildKeepsTheToleranceAndTheNextClassMayNot) {
    const HalfCurled hair;
    for (const Blend blend : {Blend::detail, Blend::option1, Blend::nearest}) {
        for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
            const ExpandSettings settings{.blend = blend, .basis = basis};
            const auto of_child = hair.of_child(settings);
            std::size_t beyond = 0;
            for (std::size_t i = 0; i < hair.binding.size(); ++i) {
                const auto distance = [&](std::size_t c) {
                    return adapted_distance(hair.binding, hair.classes, i, c, settings);
                };
                EXPECT_LE(distance(of_child[i]), HalfCurled::kTolerance);
                if (of_child[i] + 1u < hair.classes.size()) {
                    EXPECT_GT(distance(of_child[i] + 1u), 0.9 * HalfCurled::kTolerance);
                    ++beyond;
                }
            }
            EXPECT_GT(beyond, 100u);
        }
    }
}

TEST(IntervalClasses, HoldEachChildOnceAsExpandMakesIt) {
    const HalfCurled hair;
    const auto of_child = hair.of_child({});
    std::vector<int> seen(hair.binding.size(), 0);
    const std::vector<Curves> parts =
        expand_by_class(hair.binding, hair.classes, of_child, {});
    ASSERT_EQ(parts.size(), hair.classes.size());
    for (std::size_t c = 0; c < parts.size(); ++c) {
        const Curves whole = expand(hair.binding, hair.classes.profiles[c], {});
        const std::size_t n = whole.points_per_strand;
        for (std::uint32_t i = 0; i < parts[c].strands; ++i) {
            const std::uint32_t id = parts[c].id_of(i);
            ++seen[id];
            EXPECT_EQ(of_child[id], c);
            EXPECT_EQ(std::memcmp(&parts[c].points[i * n], &whole.points[id * n],
                                  n * sizeof(Point4f)),
                      0);
        }
    }
    EXPECT_TRUE(std::ranges::all_of(seen, [](int times) { return times == 1; }));
}

TEST(IntervalClasses, AChildsClassDoesNotDependOnTheOthers) {
    const HalfCurled hair;
    const auto all = hair.of_child({});
    const std::vector<std::uint32_t> which{7, 8, 300, 799};
    const auto some = child_classes(picked(hair.binding, which), hair.classes,
                                    HalfCurled::kTolerance, {});
    for (std::size_t i = 0; i < which.size(); ++i) EXPECT_EQ(some[i], all[which[i]]);
}

TEST(IntervalClasses, StrandsStandInTheirOrderWithTheirOwnPoints) {
    const HalfCurled hair;
    const auto of_child = hair.of_child({});
    const Strands strands = adapted_strands(hair.binding, hair.classes, of_child, {});
    ASSERT_EQ(strands.size(), hair.binding.size());
    ASSERT_EQ(strands.thickness.size(), strands.points.size());
    for (std::size_t i = 0; i < strands.size(); ++i) {
        ASSERT_EQ(strands.strand(i).size(),
                  std::size_t(hair.classes.counts[of_child[i]]) + 1);
        EXPECT_EQ(strands.strand(i)[0], hair.binding.roots.positions[i]);
    }
}

}  // namespace
}  // namespace lancret
