// The fallbacks of binding.

#include "procedural/bind/binding.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "procedural/bind/partings.h"
#include "tests/procedural/made_hair.h"

namespace lancret {
namespace {

using test::plane_roots;
using test::standing_guides;
using test::StandingGuides;

TEST(BindingFallbacks, CountsChildrenThatNoGuideFaces) {
    const StandingGuides standing = standing_guides(10, 1, 13);
    Roots roots = plane_roots(40, 14);
    const Binding upright = bind(roots, standing.guides, standing.normals, {});
    for (std::size_t i = 0; i < 15; ++i) roots.normals[i] = -Vec3f::UnitZ();
    const Binding binding = bind(roots, standing.guides, standing.normals, {});
    EXPECT_EQ(binding.report.no_facing_guide, 15u);
    EXPECT_EQ(upright.report.no_facing_guide, 0u);
    const Binding blind =
        bind(roots, standing.guides, standing.normals, {.facing = false});
    EXPECT_EQ(blind.report.no_facing_guide, 0u);
    // Their weights depend on distance only.
    for (std::size_t j = 0; j < 15 * 4; ++j) {
        EXPECT_EQ(binding.weights[j], blind.weights[j]);
    }
}

TEST(BindingFallbacks, CountsOpposedRootFrames) {
    StandingGuides standing = standing_guides(2, 1, 13);
    // Two guides that lie flat and point away from each other; the child is halfway.
    standing.guides.root_positions = {Vec3(-1, 0, 0), Vec3(1, 0, 0)};
    standing.guides.root_frames[0] = Mat3::Identity();
    standing.guides.root_frames[1] = Vec3(-1, -1, 1).asDiagonal();
    Roots roots = plane_roots(3, 1);
    roots.positions = {Vec3f(0, 0, 0), Vec3f(-0.9f, 0, 0), Vec3f(-0.9f, 0, 0)};
    // The normals of both guides are opposed to the third child's.
    roots.normals[2] = -Vec3f::UnitZ();
    const Binding binding =
        bind(roots, standing.guides, standing.normals, {.facing = false});
    EXPECT_EQ(binding.report.opposed_root_frames, 2u);
}

TEST(BindingFallbacks, CountsChildrenOfStraightGuides) {
    StandingGuides standing = standing_guides(40, 3, 19);
    const auto straight = [&](std::size_t g) {
        return standing.guides.root_positions[g].x() < 5;
    };
    for (std::size_t g = 0; g < 40; ++g) {
        // A guide with torsion only is straight too.
        for (std::size_t q = 3 * g; q < 3 * g + 3 && straight(g); ++q) {
            standing.guides.curvatures[q] = Vec3(0.1, 0, 0);
        }
    }
    const Binding binding =
        bind(plane_roots(300, 20), standing.guides, standing.normals, {});
    std::size_t expected = 0;
    for (std::size_t i = 0; i < 300; ++i) {
        bool all = true;
        for (std::size_t j = 4 * i; j < 4 * i + 4; ++j) {
            all = all && (binding.weights[j] == 0 || straight(binding.guides[j]));
        }
        expected += all;
    }
    EXPECT_GT(expected, 50u);
    EXPECT_EQ(binding.report.straight_guides, expected);
}

TEST(BindingFallbacks, OutOfReachAChildFollowsAVisibleGuide) {
    // Five guides 1 cm away across a parting, one visible at 3 cm, all beyond the maximum
    // distance.
    StandingGuides standing = standing_guides(6, 1, 29);
    for (int g = 0; g < 5; ++g) {
        standing.guides.root_positions[g] = Vec3(1 + 0.05 * g, 0.1 * g, 0);
    }
    standing.guides.root_positions[5] = Vec3(-3, 0, 0);
    Roots roots = plane_roots(1, 30);
    roots.positions = {Vec3f::Zero()};
    const Polyline line{{0.5, -9, 0}, {0.5, 9, 0}};
    const Partings partings({&line, 1});
    const BindBorders borders{
        .guide_regions = {}, .child_regions = {}, .partings = &partings};
    BindSettings settings;
    settings.neighbours = 2;
    settings.max_distance = 0.5;
    const Binding binding =
        lancret::bind(roots, standing.guides, standing.normals, settings, borders);
    EXPECT_EQ(binding.report.no_guide_in_reach, 1u);
    EXPECT_EQ(binding.report.no_guide_in_sight, 0u);
    EXPECT_EQ(binding.guides[0], 5u);
    EXPECT_EQ(binding.weights[0], 1.0f);
}

TEST(BindingFallbacks, CountsChildrenEnclosedByPartings) {
    const StandingGuides standing = standing_guides(10, 1, 27);
    Roots roots = plane_roots(2, 28);
    roots.positions = {Vec3f(20, 20, 0), Vec3f(5, 5, 0)};
    const Polyline square{
        {19, 19, 0}, {21, 19, 0}, {21, 21, 0}, {19, 21, 0}, {19, 19, 0}};
    const Partings partings({&square, 1});
    const BindBorders borders{
        .guide_regions = {}, .child_regions = {}, .partings = &partings};
    const Binding binding =
        lancret::bind(roots, standing.guides, standing.normals, {}, borders);
    EXPECT_EQ(binding.report.no_guide_in_sight, 1u);
    EXPECT_EQ(binding.weights[0], 1);
}

/// Expects the control polygons of all children to be no longer than the intended lengths
/// allow; the polygon of a correct curve is at most a few per cent longer. A NaN fails.
void expect_sound(const Binding& binding, const Guides& guides) {
    for (const BlendTraits& blend : blends()) {
        const auto profiles = guide_profiles<float>(guides, 32);
        const Curves curves = expand(binding, profiles, {.blend = blend.blend});
        const std::size_t points = curves.points.size() / binding.size();
        for (std::size_t i = 0; i < binding.size(); ++i) {
            float length = 0;
            for (std::size_t p = i * points + 1; p < (i + 1) * points; ++p) {
                length += (curves.points[p].xyz() - curves.points[p - 1].xyz()).norm();
            }
            // The first and last control points are at most one interval beyond the
            // curve.
            EXPECT_LE(length, binding.lengths[i] * 1.2f) << blend.name << ", child " << i;
        }
    }
}

TEST(BindingFallbacks, GrowsSoundStrandsInEveryFallback) {
    StandingGuides standing = standing_guides(12, 4, 41);
    // Two guides that point apart along the surface, one upside down, one straight.
    standing.guides.root_frames[0] = Mat3::Identity();
    standing.guides.root_frames[1] = Vec3(-1, -1, 1).asDiagonal();
    standing.guides.root_positions[0] = Vec3(-1, -20, 0);
    standing.guides.root_positions[1] = Vec3(1, -20, 0);
    standing.normals[2] = -Vec3f::UnitZ();
    standing.guides.root_positions[3] = Vec3(0, 30, 0);
    for (std::size_t q = 12; q < 16; ++q) standing.guides.curvatures[q].setZero();
    Roots roots = plane_roots(60, 42);
    roots.positions[0] = Vec3f(0, -20, 0);
    roots.positions[1] = Vec3f(0, 30, 0);
    for (std::size_t i = 10; i < 20; ++i) roots.normals[i] = -Vec3f::UnitZ();
    BindBorders borders;
    borders.guide_regions.assign(12, 0);
    borders.child_regions.assign(60, 0);
    borders.child_regions[30] = 5;
    const Polyline square{{-1, -1, 0}, {2, -1, 0}, {2, 2, 0}, {-1, 2, 0}, {-1, -1, 0}};
    const Partings partings({&square, 1});
    borders.partings = &partings;
    roots.positions[40] = Vec3f(0.5f, 0.5f, 0);
    for (std::size_t g = 0; g < 12; ++g) {  // no guide in the square
        Vec3& p = standing.guides.root_positions[g];
        if (p.x() < 2 && p.y() < 2 && p.y() > -2) p.x() += 3;
    }
    const Binding near = lancret::bind(roots, standing.guides, standing.normals,
                                       {.neighbours = 2, .max_distance = 2}, borders);
    EXPECT_GT(near.report.no_facing_guide, 0u);
    EXPECT_GT(near.report.no_guide_in_reach, 0u);
    EXPECT_GT(near.report.no_guide_in_sight, 0u);
    EXPECT_GT(near.report.no_guide_in_region, 0u);
    EXPECT_GT(near.report.opposed_root_frames, 0u);
    EXPECT_GT(near.report.straight_guides, 0u);
    expect_sound(near, standing.guides);
}

}  // namespace
}  // namespace lancret
