#include "render_test/scene/embree_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "render_test/sampling/sampling.h"
#include "render_test/trace/rays.h"
#include "tests/render_test/make_curves.h"

namespace lancret {
namespace {

/// One straight strand along +x from x = 0 to 4, at y = 1, z = 2.
Curves straight(float radius, CurveShape shape = CurveShape::flat,
                CurveBasis basis = CurveBasis::bspline) {
    std::vector<Vec3f> row;
    for (int i = 0; i <= 4; ++i) row.push_back(Vec3f(float(i), 1, 2));
    return curves_through({row}, radius, shape, basis);
}

Ray ray_to(const Vec3f& from, const Vec3f& to) {
    Ray ray;
    ray.origin = from;
    ray.direction = (to - from).normalized();
    return ray;
}

TEST(HairScene, FlatStraightStrandIsHitWhereTheRibbonIs) {
    const float radius = 0.1f;
    for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
        const Curves curves = straight(radius, CurveShape::flat, basis);
        const HairScene scene(curves);
        std::mt19937 random(1);
        std::uniform_real_distribution<float> unit(0, 1);
        for (int i = 0; i < 1000; ++i) {
            const Vec3f from(8 * unit(random) - 2, 6, 14 * unit(random) - 5);
            const float x = 0.1f + 3.8f * unit(random), h = 1.98f * unit(random) - 0.99f;
            // The ribbon at x contains the points axis + h radius across, where across is
            // perpendicular to the tangent and to the ray. The ray's direction depends on
            // h by a fraction radius / distance of itself: solved by iteration.
            const Vec3f axis(x, 1, 2), tangent(1, 0, 0);
            Vec3f target = axis, across;
            for (int k = 0; k < 8; ++k) {
                const Vec3f back = (from - target).normalized();
                const Vec3f facing = (back - tangent * back.x()).normalized();
                across = facing.cross(tangent);
                target = axis + h * radius * across;
            }
            const auto hit = scene.intersect(ray_to(from, target));
            ASSERT_TRUE(hit) << i;
            // Coordinates of 15 cm carry 1e-6 cm each, which the ray multiplies by up to
            // 1 / sin of its angle to the strand, here below 4.
            EXPECT_LT((hit->position - target).norm(), 3e-5) << i;
            EXPECT_NEAR(hit->strand.h, h, 3e-5 / radius) << i;
            EXPECT_LT((hit->strand.offset - h * radius * across).norm(), 3e-5) << i;
            EXPECT_NEAR(float(hit->primitive) + hit->u, x, 1e-4) << i;
            EXPECT_LT((hit->tangent - tangent).norm(), 1e-6) << i;
            EXPECT_FLOAT_EQ(hit->strand.radius, radius);
            EXPECT_EQ(hit->strand.index, 0u);
            EXPECT_TRUE(scene.occluded(ray_to(from, target)));
        }
    }
}

TEST(HairScene, BuildingReportsProgress) {
    std::vector<std::vector<Vec3f>> rows;
    for (int s = 0; s < 20000; ++s) {
        rows.emplace_back();
        for (int i = 0; i <= 4; ++i) rows.back().emplace_back(float(i), 0.01f * s, 2);
    }
    const Curves curves = curves_through(rows, 0.1f);
    std::vector<double> reported;
    const HairScene scene(
        curves, nullptr,
        {.true_radii = {}, .progress = [&](double done) { reported.push_back(done); }});
    EXPECT_GT(reported.size(), 2u);
    for (const double done : reported) EXPECT_TRUE(done >= 0 && done <= 1) << done;
    EXPECT_GT(*std::ranges::max_element(reported), 0.5);
}

TEST(HairScene, RaysBesideARibbonMiss) {
    const Curves curves = straight(0.1f);
    const HairScene scene(curves);
    for (const float h : {-1.02f, 1.02f, -3.0f, 3.0f}) {
        const Ray ray = ray_to(Vec3f(2, 1 + 0.1f * h, 9), Vec3f(2, 1 + 0.1f * h, 0));
        EXPECT_FALSE(scene.intersect(ray)) << h;
        EXPECT_FALSE(scene.occluded(ray)) << h;
    }
}

TEST(HairScene, RoundStrandIsHitOnItsCylinder) {
    const float radius = 0.1f;
    for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
        const Curves curves = straight(radius, CurveShape::round, basis);
        const HairScene scene(curves);
        for (int i = 0; i < 199; ++i) {
            const float y = -0.99f + 0.01f * float(i);
            const auto hit = scene.intersect(
                ray_to(Vec3f(1.6f, 1 + radius * y, 9), Vec3f(1.6f, 1 + radius * y, 0)));
            ASSERT_TRUE(hit) << y;
            // Seen along -z: facing is +z, tangent +x, facing x tangent = +y.
            const Vec3f outward(0, y, std::sqrt(1 - y * y));
            // Embree finds the root of the distance to the surface to about 1e-4 radii;
            // near the rim the error is multiplied by 1 / sqrt(1 - y^2), at most 7.
            EXPECT_LT((hit->position - (Vec3f(1.6f, 1, 2) + radius * outward)).norm(),
                      2e-3f * radius)
                << y;
            EXPECT_LT((hit->normal - outward).norm(), 1e-2f) << y;
            EXPECT_NEAR(hit->strand.h, y, 1e-2f) << y;
        }
    }
}

TEST(HairScene, PrimitivesNameTheirStrand) {
    const Curves curves = hairy_sphere(500);
    const HairScene scene(curves);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(-12, 12);
    std::set<std::uint32_t> seen;
    for (int i = 0; i < 20000; ++i) {
        const Vec3f target(unit(random), unit(random), 0);
        const auto hit = scene.intersect(ray_to(Vec3f(0, 0, 60), target));
        if (!hit) continue;
        seen.insert(hit->strand.index);
        // The hit lies within the box of its strand's control points, grown by the
        // radius.
        Eigen::AlignedBox3f box;
        for (std::uint32_t j = 0; j < curves.points_of(0); ++j) {
            box.extend(
                curves.points[std::size_t(hit->strand.index) * curves.points_of(0) + j]
                    .xyz());
        }
        EXPECT_LT(box.exteriorDistance(hit->position), 2 * hit->strand.radius);
    }
    EXPECT_GT(seen.size(), 50u);
}

TEST(HairScene, MeshHitsCarryTriangleNormalAndUv) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.uvs = {{Vec2f(0, 0), Vec2f(1, 0), Vec2f(0, 1)}};
    const Curves none = curves_through({}, 0.1f);
    const HairScene scene(none, &mesh);
    const auto hit = scene.intersect(ray_to(Vec3f(0.5f, 0.8f, 5), Vec3f(0.5f, 0.8f, 0)));
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->kind, Hit::Kind::mesh);
    EXPECT_EQ(hit->primitive, 0u);
    EXPECT_LT((hit->normal - Vec3f(0, 0, 1)).norm(), 1e-6);
    EXPECT_LT((hit->mesh.uv - Vec2f(0.25f, 0.4f)).norm(), 1e-6);
    EXPECT_NEAR(hit->distance, 5, 1e-6);
    EXPECT_GT(scene.bvh_bytes(), 0u);
}

TEST(HairScene, ACompactTreeIsMuchSmallerAndRaysMeetTheSame) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-5, 5);
    std::vector<std::vector<Vec3f>> rows;
    for (int i = 0; i < 4000; ++i) {
        const Vec3f root(place(random), place(random), place(random));
        const Vec3f way = 0.1f * Vec3f(place(random), place(random), place(random));
        rows.push_back({root, root + way, root + 2 * way + 0.1f * Vec3f::UnitX(),
                        root + 3 * way, root + 4 * way});
    }
    const Curves curves = curves_through(rows, 0.02f);
    const HairScene fast(curves), small(curves, nullptr, {.compact_from = 16'000});
    const HairScene as_fast(curves, nullptr, {.compact_from = 16'001});
    EXPECT_LT(small.bvh_bytes(), 0.65 * double(fast.bvh_bytes()));
    EXPECT_EQ(as_fast.bvh_bytes(), fast.bvh_bytes());
    int met = 0;
    for (int i = 0; i < 2000; ++i) {
        const Ray ray =
            ray_to(Vec3f(place(random), place(random), 20), Vec3f(place(random), 0, 0));
        const auto a = fast.intersect(ray), b = small.intersect(ray);
        ASSERT_EQ(a.has_value(), b.has_value());
        if (!a) continue;
        EXPECT_EQ(a->primitive, b->primitive);
        EXPECT_EQ(a->distance, b->distance);
        ++met;
    }
    EXPECT_GT(met, 200);
}

TEST(HairScene, AnEmptySceneHasNothingToHit) {
    const Curves none = curves_through({}, 0.1f);
    const HairScene scene(none);
    EXPECT_FALSE(scene.intersect(Ray{}));
    EXPECT_FALSE(scene.occluded(Ray{}));
    EXPECT_TRUE(scene.bounds().isEmpty());
}

TEST(HairScene, RefusesSegmentsOutOfTheirOrder) {
    Curves curves = straight(0.1f);
    ASSERT_GE(curves.classes[0].segments, 2u);
    std::swap(curves.segments[0], curves.segments[1]);
    EXPECT_THROW(HairScene{curves}, std::invalid_argument);
}

TEST(HairScene, RefusesIndicesOutsideTheirArrays) {
    Curves curves = straight(0.1f);
    curves.segments[3] = 4;
    EXPECT_THROW(HairScene{curves}, std::invalid_argument);
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}};
    mesh.triangles = {{0, 0, 1}};
    const Curves good = straight(0.1f);
    EXPECT_THROW(HairScene(good, &mesh), std::invalid_argument);
    mesh.triangles = {{0, 0, 0}};
    mesh.uvs = {{Vec2f(0, 0), Vec2f(NAN, 0), Vec2f(0, 0)}};
    EXPECT_THROW(HairScene(good, &mesh), std::invalid_argument);
}

TEST(StrandClearance, AStraightStrandIsNotMetAgain) {
    for (const CurveShape shape : {CurveShape::flat, CurveShape::round}) {
        const Curves curves = straight(0.05f, shape);
        const HairScene scene(curves);
        std::mt19937 random(4);
        std::uniform_real_distribution<float> unit(0, 1);
        int again = 0, with_no_clearance = 0, tries = 0;
        for (int i = 0; i < 20000; ++i) {
            const Vec3f target(1.5f + unit(random), 1 + 0.1f * unit(random) - 0.05f, 2);
            const auto hit = scene.intersect(ray_to(Vec3f(2, 1, 12), target));
            if (!hit) continue;
            Ray ray;
            ray.origin = hit->position;
            ray.direction = uniform_sphere({unit(random), unit(random)});
            // Rays at less than 1/7 to the strand count before they have left the
            // cylinder.
            if (std::abs(ray.direction.x()) > 0.99f) continue;
            ++tries;
            with_no_clearance += scene.occluded(ray);
            ray.near = strand_clearance(*hit, ray.direction);
            again += scene.occluded(ray);
        }
        EXPECT_GT(tries, 10000);
        EXPECT_EQ(again, 0);
        // Embree itself ignores a ribbon within two radii, which rays almost along the
        // strand exceed, and ignores nothing of a round strand.
        EXPECT_GT(with_no_clearance, shape == CurveShape::flat ? 50 : tries / 4);
    }
}

}  // namespace
}  // namespace lancret
