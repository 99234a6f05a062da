#include "procedural/roots/child_roots.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "tests/guides/base/temporary_folder.h"
#include "tests/guides/mesh/meshes.h"

namespace lancret {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::vector<Vec3> places(int count, unsigned seed, double side) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(0, side);
    std::vector<Vec3> out;
    for (int i = 0; i < count; ++i) {
        const double x = place(random), y = place(random);
        out.emplace_back(x, y, 0);
    }
    return out;
}

double nearest(const std::vector<Vec3>& all, const Vec3& x) {
    double out = 1e9;
    for (const Vec3& p : all) out = std::min(out, (p - x).norm());
    return out;
}

Roots roots_on_scalp(const Scalp& scalp, std::span<const Vec3> grown, std::uint32_t count,
                     std::uint64_t seed, double growth) {
    return roots_at(&scalp,
                    {.on_scalp = places_on_scalp(scalp, grown, count, seed, growth),
                     .on_strands = {}});
}

TEST(RootsOfStrands, NeedAScalpIfThereAreTooFew) {
    const auto grown = places(10, 1, 5);
    const std::vector<Vec3> tangents(10, Vec3::UnitZ());
    const std::string error =
        input_error([&] { roots_of_strands(grown, tangents, 11, 0, "a.hair"); });
    EXPECT_THAT(error, StartsWith("a.hair: 11 children"));
    EXPECT_THAT(error, HasSubstr("--scalp"));
    EXPECT_THAT(error, HasSubstr("10 roots"));
}

TEST(RootsOfStrands, AreDifferentRootsOfTheGroom) {
    const auto grown = places(50, 2, 5);
    const std::vector<Vec3> tangents(50, Vec3::UnitZ());
    for (const std::uint32_t count : {1u, 20u, 50u}) {
        const Roots roots = roots_of_strands(grown, tangents, count, 3, "a");
        ASSERT_EQ(roots.size(), count);
        std::set<std::size_t> seen;
        for (const Vec3f& p : roots.positions) {
            const auto at = std::ranges::find_if(
                grown, [&](const Vec3& g) { return g.cast<float>() == p; });
            ASSERT_NE(at, grown.end());
            seen.insert(at - grown.begin());
        }
        EXPECT_EQ(seen.size(), count);
        EXPECT_TRUE(roots.uvs.empty());
    }
}

TEST(RootsOfStrands, RootDoesNotDependOnTheCount) {
    const auto grown = places(60, 4, 5);
    const std::vector<Vec3> tangents(60, Vec3::UnitZ());
    const Roots many = roots_of_strands(grown, tangents, 59, 7, "a");
    const Roots few = roots_of_strands(grown, tangents, 13, 7, "a");
    for (std::size_t i = 0; i < 13; ++i) EXPECT_EQ(few.positions[i], many.positions[i]);
    const Roots other = roots_of_strands(grown, tangents, 13, 8, "a");
    EXPECT_NE(few.positions, other.positions);
}

TEST(RootsOfStrands, NormalsAreTheMeanTangentOfTheEightNearest) {
    const auto grown = places(40, 5, 5);
    std::mt19937 random(6);
    std::normal_distribution<double> lean(0, 0.3);
    std::vector<Vec3> tangents;
    for (int i = 0; i < 40; ++i) {
        const double x = lean(random), y = lean(random);
        tangents.push_back(Vec3(x, y, 1).normalized());
    }
    const Roots roots = roots_of_strands(grown, tangents, 40, 0, "a");
    for (std::size_t i = 0; i < 40; ++i) {
        const Vec3 x = roots.positions[i].cast<double>();
        std::vector<std::size_t> order(40);
        std::iota(order.begin(), order.end(), 0u);
        std::ranges::sort(order, {},
                          [&](std::size_t j) { return (grown[j] - x).norm(); });
        Vec3 mean = Vec3::Zero();
        for (int k = 0; k < 8; ++k) mean += tangents[order[k]];
        // Rounded to float.
        EXPECT_LT((roots.normals[i].cast<double>() - mean.normalized()).norm(), 1e-6);
    }
}

TEST(RootsOnScalp, AreOnTheScalpNearTheGroomOnly) {
    const Scalp scalp = make_scalp(square_mesh(10, 8));
    const auto grown = places(200, 7, 4);
    const Roots roots = roots_on_scalp(scalp, grown, 1000, 1, 0.5);
    ASSERT_EQ(roots.size(), 1000u);
    double farthest = 0;
    for (std::size_t i = 0; i < 1000; ++i) {
        const Vec3 x = roots.positions[i].cast<double>();
        EXPECT_EQ(x.z(), 0);
        EXPECT_EQ(roots.normals[i], Vec3f::UnitZ());
        // The filter works in double; positions are rounded to float.
        EXPECT_LE(nearest(grown, x), 0.5 + 1e-6);
        farthest = std::max({farthest, x.x(), x.y()});
        // On this square, UVs are the position over its side.
        EXPECT_LT((roots.uvs[i].cast<double>() - x.head<2>() / 10).norm(), 1e-6);
        EXPECT_LT((scalp_position(scalp, roots.places[i]) - x).norm(), 1e-6);
    }
    // They also fill the strip beyond the outermost strands.
    EXPECT_GT(farthest, 4.1);
}

TEST(RootsOnScalp, CoverTheWholeScalpWithoutALimit) {
    const Scalp scalp = make_scalp(square_mesh(10, 8));
    const std::vector<Vec3> grown = {Vec3(1, 1, 0)};
    const Roots roots =
        roots_on_scalp(scalp, grown, 4000, 1, std::numeric_limits<double>::infinity());
    int quarter[4] = {};
    for (const Vec3f& p : roots.positions) ++quarter[(p.x() > 5) + 2 * (p.y() > 5)];
    // Independent roots would give 1000 with a standard deviation of 27; these are more
    // even.
    for (const int count : quarter) EXPECT_NEAR(count, 1000, 4 * 27);
}

TEST(RootsOnScalp, RootDoesNotDependOnTheCount) {
    const Scalp scalp = make_scalp(square_mesh(10, 8));
    const auto grown = places(100, 8, 10);
    const Roots few = roots_on_scalp(scalp, grown, 77, 5, 0.8);
    const Roots many = roots_on_scalp(scalp, grown, 3000, 5, 0.8);
    for (std::size_t i = 0; i < 77; ++i) {
        EXPECT_EQ(few.positions[i], many.positions[i]);
        EXPECT_EQ(few.normals[i], many.normals[i]);
    }
}

TEST(RootsOnScalp, ThrowIfTheGroomIsElsewhere) {
    const Scalp scalp = make_scalp(square_mesh(10, 8));
    const std::vector<Vec3> grown = {Vec3(500, 0, 0)};
    EXPECT_NE(input_error([&] { roots_on_scalp(scalp, grown, 10, 0, 1); }), "");
}

TEST(Growth, IsOneAndAHalfSpacings) {
    std::vector<Vec3> grid;
    for (int i = 0; i < 100; ++i) grid.emplace_back(2.0 * (i % 10), 2.0 * (i / 10), 0);
    EXPECT_DOUBLE_EQ(growth_of_spacing(grid), 3);
    // One stray strand does not change it.
    grid.emplace_back(100, 100, 0);
    EXPECT_DOUBLE_EQ(growth_of_spacing(grid), 3);
}

}  // namespace
}  // namespace lancret
