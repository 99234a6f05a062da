// Strands with different numbers of segments in one scene.

#include <gtest/gtest.h>

#include "render_test/scene/thin_strands.h"
#include "render_test/trace/check_view.h"
#include "tests/render_test/make_curves.h"

namespace lancret {
namespace {

/// Straight strands side by side, from z = 0 to 8: `fine` of them with 8 segments, then
/// `coarse` with `segments`.
Curves straight_strands(std::uint32_t fine, std::uint32_t coarse, std::uint32_t segments,
                        CurveBasis basis) {
    Curves out;
    out.basis = basis;
    out.add_class(fine, 8);
    out.add_class(coarse, segments);
    out.points = Buffer<Point4f>(out.point_count());
    out.tangents = Buffer<Point4f>(basis == CurveBasis::hermite ? out.point_count() : 0);
    out.segments = Buffer<std::uint32_t>(out.segment_count());
    for (std::uint32_t j = 0; j < out.segments.size(); ++j) {
        out.segments[j] = out.place_of(j).point;
    }
    for (std::uint32_t i = 0; i < out.strands; ++i) {
        const float step = 8 / float(out.class_of(i).segments);
        for (std::uint32_t j = 0; j < out.points_of(i); ++j) {
            const std::uint32_t at = out.first_point(i) + j;
            const float along = basis == CurveBasis::hermite ? float(j) : float(j) - 1;
            out.points[at] = {float(i), 0, step * along, 0.1f};
            if (basis == CurveBasis::hermite) out.tangents[at] = {0, 0, step, 0};
        }
    }
    return out;
}

TEST(ClassedStrands, AreHitLikeUniformStrands) {
    for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
        for (const CurveShape shape : {CurveShape::flat, CurveShape::round}) {
            Curves alike = straight_strands(7, 0, 1, basis);
            Curves classed = straight_strands(3, 4, 2, basis);
            alike.shape = classed.shape = shape;
            classed.ids = {4, 6, 5, 0, 1, 2, 3};
            const HairScene a(alike), b(classed);
            for (std::uint32_t i = 0; i < 7; ++i) {
                for (int k = 0; k < 16; ++k) {
                    Ray ray;
                    ray.origin = {float(i) + 0.03f, 5, 0.25f + 0.5f * float(k)};
                    ray.direction = -Vec3f::UnitY();
                    const auto one = a.intersect(ray), other = b.intersect(ray);
                    ASSERT_TRUE(one && other) << i << ' ' << k;
                    EXPECT_EQ(other->strand.index, i);
                    EXPECT_EQ(other->strand.id, classed.ids[i]);
                    EXPECT_NEAR(other->strand.along, ray.origin.z() / 8, 1e-4f);
                    EXPECT_NEAR(other->strand.along, one->strand.along, 1e-4f);
                    EXPECT_NEAR(other->distance, one->distance, 1e-4f);
                    EXPECT_NEAR(other->strand.h, one->strand.h, 1e-3f);
                    EXPECT_NEAR(other->strand.radius, one->strand.radius, 1e-6f);
                }
            }
        }
    }
}

TEST(ClassedStrands, AreWidenedEachWithItsOwnPoints) {
    Curves curves = straight_strands(2, 3, 1, CurveBasis::hermite);
    Camera camera;
    camera.position = {2, 0, 1000};
    const std::vector<float> before = widen_thin_strands(curves, {&camera, 1}, 8, 1);
    ASSERT_EQ(before.size(), curves.points.size());
    for (const float radius : before) EXPECT_EQ(radius, 0.1f);
    // An eighth of the picture at about 990 cm: 45 cm, almost constant along the strand.
    for (const Point4f& p : curves.points.span()) EXPECT_NEAR(p.w, 45, 1);
    for (const Point4f& t : curves.tangents.span()) EXPECT_LT(t.w, 0);
}

TEST(ClassedStrands, ATableThatDoesNotFitIsRefused) {
    const auto refused = [](const auto& spoil) {
        Curves curves = straight_strands(2, 2, 4, CurveBasis::bspline);
        spoil(curves);
        EXPECT_THROW(HairScene(curves, nullptr), std::invalid_argument);
    };
    refused([](Curves& c) { c.classes[1].strands = 3; });
    refused([](Curves& c) { c.classes[1].point += 1; });
    refused([](Curves& c) { c.classes[0].segments = 7; });
    refused([](Curves& c) { c.classes.pop_back(); });
    refused([](Curves& c) { c.strands = 5; });
    refused([](Curves& c) { c.segments[9] = 0; });
}

TEST(ClassedStrands, AreSelectedByTheirValues) {
    const Curves curves = straight_strands(3, 2, 2, CurveBasis::bspline);
    CheckView view;
    view.scale.clean = 0.5f;
    view.values.first = {0, 8, 16, 24, 26, 28};
    view.values.values.assign(28, 0);
    view.values.values[9] = view.values.values[27] = 1;  // strands 1 and 4
    const auto apart = strands_apart(view, curves, nullptr);
    EXPECT_EQ(apart->strands, (std::vector<std::uint32_t>{1, 4}));
    ASSERT_EQ(apart->curves.points.size(), 11u + 5u);
    EXPECT_EQ(apart->curves.points[0].x, 1);
    EXPECT_EQ(apart->curves.points[11].x, 4);
    EXPECT_EQ(view.values.at(4, 0.9f), 1);
    EXPECT_EQ(view.values.at(4, 0.1f), 0);
}

}  // namespace
}  // namespace lancret
