#include "procedural/binding.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <numeric>

#include "tests/procedural/made_hair.h"

namespace lancret {
namespace {

using test::guide_roots;
using test::plane_roots;
using test::standing_guides;
using test::StandingGuides;

TEST(Binding, FindsTheExactNearestGuides) {
    const StandingGuides standing = standing_guides(200, 1, 3);
    const Binding binding =
        bind(plane_roots(300, 4), standing.guides, standing.normals, {.neighbours = 5});
    ASSERT_EQ(binding.neighbours, 5);
    for (std::size_t i = 0; i < binding.size(); ++i) {
        const Vec3 x = binding.roots.positions[i].cast<double>();
        std::vector<std::uint32_t> order(200);
        std::iota(order.begin(), order.end(), 0u);
        std::ranges::sort(order, {}, [&](std::uint32_t g) {
            return (standing.guides.root_positions[g] - x).squaredNorm();
        });
        for (int k = 0; k < 5; ++k) EXPECT_EQ(binding.guides[i * 5 + k], order[k]);
    }
}

TEST(Binding, LengthIsTheWeightedLengthOfTheGuidesTimesTheScale) {
    const StandingGuides standing = standing_guides(30, 3, 5);
    for (const float scale : {1.0f, 0.4f}) {
        const Binding binding = bind(plane_roots(200, 6), standing.guides,
                                     standing.normals, {.length_scale = scale});
        for (std::size_t i = 0; i < binding.size(); ++i) {
            double length = 0, sum = 0;
            for (std::size_t k = i * 4; k < i * 4 + 4; ++k) {
                length +=
                    binding.weights[k] * guide_length(standing.guides, binding.guides[k]);
                sum += binding.weights[k];
            }
            EXPECT_NEAR(sum, 1, 4 * 3e-8);
            // One rounding to float.
            EXPECT_NEAR(binding.lengths[i], scale * length, 1e-7 * length);
        }
    }
}

TEST(Binding, IsTheSameForAnyNumberOfThreads) {
    const StandingGuides standing = standing_guides(50, 2, 7);
    const auto made = [&](int threads) {
        tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    threads);
        return bind(plane_roots(5000, 8), standing.guides, standing.normals, {});
    };
    const Binding one = made(1);
    for (const int threads : {2, 5}) {
        const Binding many = made(threads);
        EXPECT_EQ(many.guides, one.guides);
        EXPECT_EQ(many.weights, one.weights);
        EXPECT_EQ(many.lengths, one.lengths);
    }
}

TEST(Binding, AChildOnAGuidesRootIsThatGuide) {
    const StandingGuides standing = standing_guides(20, 3, 9);
    const Binding binding =
        bind(guide_roots(standing), standing.guides, standing.normals, {});
    const auto profiles = guide_profiles<double>(standing.guides, 6);
    for (std::size_t i = 0; i < 20; ++i) {
        const BoundChild<double> bound = bound_child(binding, profiles, i);
        // The root, rounded to float, is within 1e-6 of the guide's; the next one is some
        // 0.1 away, so that its share is below (1e-5)^2.
        EXPECT_EQ(bound.guides[0], i);
        EXPECT_NEAR(bound.weights[0], 1, 1e-9);
        // No turn from a normal to itself.
        EXPECT_EQ(bound.to_space[0], standing.guides.root_frames[i]);
        EXPECT_NEAR(bound.length, guide_length(standing.guides, i), 1e-6 * bound.length);
    }
}

TEST(Binding, TurnsAGuidesFrameByTheSmallestRotationToTheChildsNormal) {
    StandingGuides standing = standing_guides(1, 2, 11);
    Roots roots = plane_roots(1, 12);
    roots.normals[0] = Vec3f(1, 2, 3).normalized();
    const Binding binding = bind(roots, standing.guides, standing.normals, {});
    const auto profiles = guide_profiles<double>(standing.guides, 2);
    const BoundChild<double> bound = bound_child(binding, profiles, 0);
    const Vec3 from = Vec3::UnitZ(), to = roots.normals[0].cast<double>();
    const Mat3 turn = bound.to_space[0] * standing.guides.root_frames[0].transpose();
    // The normal in floats is a unit vector to 1e-7.
    EXPECT_LT((turn * from - to).norm(), 2e-7);
    EXPECT_LT((turn.transpose() * turn - Mat3::Identity()).norm(), 1e-6);
    // The smallest of the rotations that do so leaves the axis across both where it is.
    const Vec3 axis = from.cross(to).normalized();
    EXPECT_LT((turn * axis - axis).norm(), 2e-7);
}

TEST(Binding, CountsChildrenThatNoGuideFaces) {
    const StandingGuides standing = standing_guides(10, 1, 13);
    Roots roots = plane_roots(40, 14);
    for (std::size_t i = 0; i < 15; ++i) roots.normals[i] = -Vec3f::UnitZ();
    const Binding binding = bind(roots, standing.guides, standing.normals, {});
    EXPECT_EQ(binding.report.nearest_guide, 15u);
    for (std::size_t i = 0; i < 15; ++i) {
        EXPECT_EQ(binding.weights[4 * i], 1);
        for (int k = 1; k < 4; ++k) EXPECT_EQ(binding.weights[4 * i + k], 0);
    }
}

TEST(Binding, HasNoMoreNeighboursThanGuides) {
    const StandingGuides standing = standing_guides(3, 1, 15);
    const Binding binding =
        bind(plane_roots(20, 16), standing.guides, standing.normals, {.neighbours = 8});
    EXPECT_EQ(binding.neighbours, 3);
    EXPECT_EQ(binding.weights.size(), 60u);
    // With every guide a neighbour there is no reach: none has weight zero.
    EXPECT_GT(*std::ranges::min_element(binding.weights), 0);
}

TEST(Binding, RejectsWhatCannotBeBound) {
    const StandingGuides standing = standing_guides(3, 1, 17);
    EXPECT_THROW(bind(plane_roots(2, 1), {}, {}, {}), std::invalid_argument);
    for (const int neighbours : {0, -1, kMaxNeighbours + 1}) {
        EXPECT_THROW(bind(plane_roots(2, 1), standing.guides, standing.normals,
                          {.neighbours = neighbours}),
                     std::invalid_argument);
    }
}

TEST(Binding, CountsItsBytes) {
    const StandingGuides standing = standing_guides(10, 1, 18);
    const Binding binding =
        bind(plane_roots(100, 1), standing.guides, standing.normals, {.neighbours = 3});
    // Positions and normals, three guides and weights, a length; and a normal a guide.
    EXPECT_EQ(binding.bytes(), 100u * (2 * 12 + 3 * (4 + 4) + 4) + 10 * 12);
}

}  // namespace
}  // namespace lancret
