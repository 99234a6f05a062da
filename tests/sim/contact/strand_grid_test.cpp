#include "sim/contact/strand_grid.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>

namespace lancret {
namespace {

struct Points {
    std::vector<Vec3> positions;
    std::vector<std::uint32_t> strands;
};

/// Strands of `stations` points each, random walks from random roots.
Points walks(int strands, int stations, double size, double step, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Points out;
    for (int s = 0; s < strands; ++s) {
        Vec3 p = size * Vec3(normal(random), normal(random), normal(random));
        for (int i = 0; i < stations; ++i) {
            out.positions.push_back(p);
            out.strands.push_back(std::uint32_t(s));
            p += step * Vec3(normal(random), normal(random), normal(random));
        }
    }
    return out;
}

/// (distance^2, point) of the nearest point of each other strand within the radius, in
/// ascending order, at most kMax of them.
std::vector<std::pair<double, std::uint32_t>> brute_force(const Points& points,
                                                          std::size_t of, double radius) {
    std::map<std::uint32_t, std::pair<double, std::uint32_t>> nearest;
    for (std::uint32_t i = 0; i < points.positions.size(); ++i) {
        const double d2 = (points.positions[i] - points.positions[of]).squaredNorm();
        if (points.strands[i] == points.strands[of] || d2 > radius * radius) continue;
        const std::pair candidate(d2, i);
        const auto at = nearest.try_emplace(points.strands[i], candidate).first;
        at->second = std::min(at->second, candidate);
    }
    std::vector<std::pair<double, std::uint32_t>> out;
    for (const auto& [strand, found] : nearest) out.push_back(found);
    std::ranges::sort(out);
    out.resize(std::min<std::size_t>(out.size(), StrandGrid::kMax));
    return out;
}

/// Expects the result of brute force; returns the number of points with kMax neighbours.
int expect_brute_force(StrandGrid& grid, const Points& points, double radius) {
    grid.find(points.positions, points.strands, radius);
    int full = 0;
    for (std::size_t i = 0; i < points.positions.size(); ++i) {
        const auto expected = brute_force(points, i, radius);
        const auto found = grid.neighbours(i);
        EXPECT_EQ(found.size(), expected.size());
        for (std::size_t k = 0; k < std::min(found.size(), expected.size()); ++k) {
            EXPECT_EQ(found[k].point, expected[k].second);
            EXPECT_EQ(found[k].distance, std::sqrt(expected[k].first));
        }
        full += found.size() == StrandGrid::kMax;
    }
    return full;
}

TEST(StrandGrid, FindsWhatBruteForceFinds) {
    StrandGrid grid;
    const Points points = walks(60, 20, 0.4, 0.1, 1);
    EXPECT_EQ(expect_brute_force(grid, points, 1e-6), 0);
    EXPECT_GT(expect_brute_force(grid, points, 0.3), 100);
    EXPECT_GT(expect_brute_force(grid, points, 1), 1000);
    EXPECT_EQ(expect_brute_force(grid, points, 100), 1200);
}

TEST(StrandGrid, FindsAcrossCellsFarFromTheOrigin) {
    StrandGrid grid;
    Points points = walks(60, 20, 0.4, 0.1, 2);
    for (Vec3& p : points.positions) p += Vec3(-1e4, 1e5, 1e-3);
    EXPECT_GT(expect_brute_force(grid, points, 0.3), 100);
}

TEST(StrandGrid, TiesGoToTheLowerIndex) {
    // A lattice whose strands run along x: many distances are equal, many exactly the
    // radius.
    Points points;
    for (std::uint32_t i = 0; i < 512; ++i) {
        points.positions.push_back({double(i % 8), double(i / 8 % 8), double(i / 64)});
        points.strands.push_back(i / 8);
    }
    StrandGrid grid;
    EXPECT_GT(expect_brute_force(grid, points, 1), 100);
    EXPECT_GT(expect_brute_force(grid, points, 2), 300);
    // With shuffled strand numbers.
    for (std::uint32_t& s : points.strands) s = (s * 37 + 5) % 64 + 4000000000u;
    EXPECT_GT(expect_brute_force(grid, points, 2), 300);
}

TEST(StrandGrid, OneStrandHasNoNeighbours) {
    StrandGrid grid;
    const Points points = walks(1, 50, 1, 0.01, 3);
    grid.find(points.positions, points.strands, 10);
    for (std::size_t i = 0; i < 50; ++i) EXPECT_TRUE(grid.neighbours(i).empty());
    grid.find({}, {}, 1);  // no points at all
}

TEST(StrandGrid, CoincidentPointsAreNeighboursAtDistanceZero) {
    Points points;
    for (std::uint32_t s = 0; s < 10; ++s) {
        points.positions.push_back({-0.0, 0, 0});
        points.strands.push_back(s);
    }
    points.positions[3].x() = 0;
    StrandGrid grid;
    grid.find(points.positions, points.strands, 0.1);
    const auto found = grid.neighbours(2);
    ASSERT_EQ(found.size(), 4u);
    const std::uint32_t expected[] = {0, 1, 3, 4};
    for (int k = 0; k < 4; ++k) {
        EXPECT_EQ(found[k].point, expected[k]);
        EXPECT_EQ(found[k].distance, 0);
    }
}

TEST(StrandGrid, IsTheSameForAnyNumberOfThreads) {
    const Points points = walks(500, 40, 3, 0.1, 4);
    StrandGrid one, many;
    many.find(points.positions, points.strands, 0.5);
    {
        const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
        one.find(points.positions, points.strands, 0.5);
    }
    for (std::size_t i = 0; i < points.positions.size(); ++i) {
        const auto a = one.neighbours(i), b = many.neighbours(i);
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t k = 0; k < a.size(); ++k) {
            EXPECT_EQ(a[k].point, b[k].point);
            EXPECT_EQ(a[k].distance, b[k].distance);
        }
    }
}

TEST(StrandGrid, KeepsItsBuffersFromCallToCall) {
    StrandGrid grid;
    const Points points = walks(100, 20, 1, 0.1, 5), fewer = walks(30, 20, 1, 0.1, 6);
    grid.find(points.positions, points.strands, 0.5);
    const auto* data = grid.neighbours(0).data();
    expect_brute_force(grid, fewer, 0.5);
    expect_brute_force(grid, points, 0.4);
    EXPECT_EQ(grid.neighbours(0).data(), data);
}

TEST(StrandGrid, RejectsInvalidArguments) {
    StrandGrid grid;
    Points points = walks(2, 2, 1, 0.1, 7);
    EXPECT_THROW(grid.find(points.positions, {}, 1), std::invalid_argument);
    for (const double radius : {0.0, -1.0, std::nan("")}) {
        EXPECT_THROW(grid.find(points.positions, points.strands, radius),
                     std::invalid_argument);
    }
    EXPECT_THROW(grid.find(points.positions, points.strands, 1e-12),
                 std::invalid_argument);
    points.positions[1].z() = std::nan("");
    EXPECT_THROW(grid.find(points.positions, points.strands, 1), std::invalid_argument);
}

}  // namespace
}  // namespace lancret
