#include "guides/base/farthest_points.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace lancret {
namespace {

std::vector<Vec3> random_points(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform;
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        points.emplace_back(uniform(random), uniform(random), 0.1);
    }
    return points;
}

TEST(FarthestPoints, MatchTheQuadraticAlgorithm) {
    const auto points = random_points(500, 1);
    const auto chosen = farthest_points(points, 120, 7);
    std::vector<double> squared(points.size(), 1e300);
    std::size_t next = 7;
    for (const std::uint32_t index : chosen) {
        ASSERT_EQ(index, next);
        for (std::size_t i = 0; i < points.size(); ++i) {
            squared[i] = std::min(squared[i], (points[i] - points[index]).squaredNorm());
        }
        next = std::max_element(squared.begin(), squared.end()) - squared.begin();
    }
}

TEST(FarthestPoints, ASmallerChoiceBeginsALargerOne) {
    const auto points = random_points(300, 2);
    const auto few = farthest_points(points, 20, 0),
               many = farthest_points(points, 200, 0);
    EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
}

TEST(FarthestPoints, TakesEachPointOnceEvenIfSomeCoincide) {
    std::vector<Vec3> points(50, Vec3::Zero());
    points[3] = Vec3::UnitX();
    const auto chosen = farthest_points(points, 40, 0);
    EXPECT_EQ(std::set(chosen.begin(), chosen.end()).size(), 40u);
    EXPECT_EQ(chosen[1], 3u);
}

TEST(FarthestPoints, NeighbourDistancesMatchBruteForce) {
    const auto points = random_points(100, 3);
    const auto distances = neighbour_distances(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        double nearest = 1e300;
        for (std::size_t j = 0; j < points.size(); ++j) {
            if (j != i) nearest = std::min(nearest, (points[i] - points[j]).norm());
        }
        EXPECT_DOUBLE_EQ(distances[i], nearest);
    }
}

}  // namespace
}  // namespace lancret
