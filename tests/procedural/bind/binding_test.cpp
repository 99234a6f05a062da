#include "procedural/bind/binding.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <numeric>

#include "procedural/bind/partings.h"
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
            // Rounded to float once.
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
        // The root, rounded to float, is within 1e-6 of the guide's; the next guide is
        // about 0.1 away, so that its weight is below (1e-5)^2.
        EXPECT_EQ(bound.guides[0], i);
        EXPECT_NEAR(bound.weights[0], 1, 1e-9);
        // The rotation from a normal to itself is the identity.
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
    // The normal has unit length to 1e-7 in float.
    EXPECT_LT((turn * from - to).norm(), 2e-7);
    EXPECT_LT((turn.transpose() * turn - Mat3::Identity()).norm(), 1e-6);
    // The smallest of these rotations keeps the axis across both normals fixed.
    const Vec3 axis = from.cross(to).normalized();
    EXPECT_LT((turn * axis - axis).norm(), 2e-7);
}

TEST(Binding, GuidesBeyondTheMaximumDistanceHaveNoWeight) {
    const StandingGuides standing = standing_guides(100, 1, 21);
    const Roots roots = plane_roots(2000, 22);
    const Binding binding =
        bind(roots, standing.guides, standing.normals, {.max_distance = 0.6});
    std::size_t out_of_reach = 0;
    for (std::size_t i = 0; i < 2000; ++i) {
        const auto distance = [&](std::uint32_t g) {
            return (standing.guides.root_positions[g] - roots.positions[i].cast<double>())
                .norm();
        };
        double nearest = 1e9;
        for (std::uint32_t g = 0; g < 100; ++g) nearest = std::min(nearest, distance(g));
        if (nearest >= 0.6) {
            ++out_of_reach;
            EXPECT_EQ(binding.weights[4 * i], 1);
            EXPECT_EQ(distance(binding.guides[4 * i]), nearest);
            continue;
        }
        for (std::size_t j = 4 * i; j < 4 * i + 4; ++j) {
            if (binding.weights[j] > 0) {
                EXPECT_LT(distance(binding.guides[j]), 0.6);
            }
        }
    }
    EXPECT_GT(out_of_reach, 100u);
    EXPECT_EQ(binding.report.no_guide_in_reach, out_of_reach);
}

TEST(Binding, GuidesBeyondTheMaximumAngleHaveNoWeight) {
    StandingGuides standing = standing_guides(100, 1, 23);
    for (std::size_t g = 0; g < 100; g += 2) {
        standing.normals[g] = Vec3f(std::sin(0.4f), 0, std::cos(0.4f));
    }
    const Binding binding = bind(plane_roots(500, 24), standing.guides, standing.normals,
                                 {.max_angle = 0.39});
    for (std::size_t j = 0; j < binding.weights.size(); ++j) {
        EXPECT_TRUE(binding.weights[j] == 0 || binding.guides[j] % 2 == 1);
    }
    // The next guides within the angle replace them.
    for (std::size_t i = 0; i < binding.size(); ++i) {
        EXPECT_EQ(std::ranges::count_if(std::span(&binding.weights[4 * i], 4),
                                        [](float w) { return w > 0; }),
                  4);
    }
    EXPECT_EQ(binding.report.no_guide_in_reach, 0u);
    const Binding none = bind(plane_roots(5, 24), standing.guides,
                              std::vector<Vec3f>(100, Vec3f::UnitX()), {.max_angle = 1});
    EXPECT_EQ(none.report.no_guide_in_reach, 5u);
}

TEST(Binding, ChildrenHaveGuidesOfTheirRegionOnly) {
    const StandingGuides standing = standing_guides(60, 1, 25);
    const Roots roots = plane_roots(600, 26);
    BindBorders borders;
    for (const Vec3& p : standing.guides.root_positions) {
        borders.guide_regions.push_back(p.x() < 4 ? 7 : 9);
    }
    for (const Vec3f& p : roots.positions) {
        borders.child_regions.push_back(p.x() < 4 ? 7 : p.x() > 9.5f ? 1000 : 9);
    }
    const Binding binding =
        lancret::bind(roots, standing.guides, standing.normals, {}, borders);
    std::size_t without = 0;
    for (std::size_t i = 0; i < 600; ++i) {
        without += borders.child_regions[i] == 1000;
        for (std::size_t j = 4 * i; j < 4 * i + 4 && borders.child_regions[i] < 10; ++j) {
            EXPECT_EQ(borders.guide_regions[binding.guides[j]], borders.child_regions[i]);
            EXPECT_GT(binding.weights[j], 0);
        }
    }
    EXPECT_GT(without, 10u);
    EXPECT_EQ(binding.report.no_guide_in_region, without);
}

TEST(Binding, NoChildsGuidesLieAcrossAParting) {
    const StandingGuides standing = standing_guides(100, 1, 27);
    const Polyline bent{{5, -1, 0}, {4.5, 4, 0.1}, {6, 7, 0}};
    const Partings partings({&bent, 1});
    const BindBorders borders{
        .guide_regions = {}, .child_regions = {}, .partings = &partings};
    const Roots roots = plane_roots(3000, 28);
    const Binding binding =
        lancret::bind(roots, standing.guides, standing.normals, {}, borders);
    const auto crosses = [&](const Vec3& a, const Vec3& b) {
        const auto side = [](const Vec3& p, const Vec3& q, const Vec3& r) {
            return (q - p)
                       .head<2>()
                       .homogeneous()
                       .cross((r - p).head<2>().homogeneous())
                       .z() > 0;
        };
        for (std::size_t i = 0; i + 1 < bent.size(); ++i) {
            const Vec3 &p = bent[i], &q = bent[i + 1];
            if (side(p, q, a) != side(p, q, b) && side(a, b, p) != side(a, b, q)) {
                return true;
            }
        }
        return false;
    };
    const Binding free = bind(roots, standing.guides, standing.normals, {});
    std::size_t would_cross = 0;
    for (std::size_t j = 0; j < binding.guides.size(); ++j) {
        const Vec3 root = roots.positions[j / 4].cast<double>();
        EXPECT_FALSE(crosses(root, standing.guides.root_positions[binding.guides[j]]));
        would_cross += crosses(root, standing.guides.root_positions[free.guides[j]]);
    }
    EXPECT_GT(would_cross, 300u);
    EXPECT_EQ(binding.report.no_guide_in_sight, 0u);
}

TEST(Binding, HasNoMoreNeighboursThanGuides) {
    const StandingGuides standing = standing_guides(3, 1, 15);
    const Binding binding =
        bind(plane_roots(20, 16), standing.guides, standing.normals, {.neighbours = 8});
    EXPECT_EQ(binding.neighbours, 3);
    EXPECT_EQ(binding.weights.size(), 60u);
    // If every guide is a neighbour, the reach is infinite and no weight is zero.
    EXPECT_GT(*std::ranges::min_element(binding.weights), 0);
}

TEST(Binding, RejectsMissingGuidesAndBadNeighbourCounts) {
    const StandingGuides standing = standing_guides(3, 1, 17);
    EXPECT_THROW(bind(plane_roots(2, 1), {}, {}, {}), std::invalid_argument);
    for (const int neighbours : {0, -1, kMaxNeighbours + 1}) {
        EXPECT_THROW(bind(plane_roots(2, 1), standing.guides, standing.normals,
                          {.neighbours = neighbours}),
                     std::invalid_argument);
    }
}

TEST(Binding, RejectsBordersThatDoNotFit) {
    const StandingGuides standing = standing_guides(3, 1, 17);
    const auto regions = [&](std::size_t guides, std::size_t children) {
        const BindBorders borders{.guide_regions = std::vector<std::uint32_t>(guides),
                                  .child_regions = std::vector<std::uint32_t>(children),
                                  .partings = nullptr};
        return lancret::bind(plane_roots(2, 1), standing.guides, standing.normals, {},
                             borders);
    };
    EXPECT_NO_THROW(regions(3, 2));
    EXPECT_THROW(regions(2, 2), std::invalid_argument);
    EXPECT_THROW(regions(3, 0), std::invalid_argument);
    for (const double none : {0.0, -1.0, double(NAN)}) {
        EXPECT_THROW(bind(plane_roots(2, 1), standing.guides, standing.normals,
                          {.max_distance = none}),
                     std::invalid_argument);
        EXPECT_THROW(bind(plane_roots(2, 1), standing.guides, standing.normals,
                          {.max_angle = none}),
                     std::invalid_argument);
    }
}

TEST(Binding, CountsItsBytes) {
    const StandingGuides standing = standing_guides(10, 1, 18);
    const Binding binding =
        bind(plane_roots(100, 1), standing.guides, standing.normals, {.neighbours = 3});
    // Per child: position and normal, three guides and weights, a length; per guide: a
    // normal.
    EXPECT_EQ(binding.bytes(), 100u * (2 * 12 + 3 * (4 + 4) + 4) + 10 * 12);
}

}  // namespace
}  // namespace lancret
