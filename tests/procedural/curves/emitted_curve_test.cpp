#include "procedural/curves/emitted_curve.h"

#include <gtest/gtest.h>

#include <utility>

#include "tests/procedural/curves/emitted.h"

namespace lancret {
namespace {

using test::Emitted;
using test::helix_states;

TEST(BasisLayout, CountsControlPointsAndSegments) {
    const std::pair<CurveBasis, std::uint32_t> points_of_five_intervals[] = {
        {CurveBasis::bspline, 8},
        {CurveBasis::hermite, 6},
        {CurveBasis::linear, 6},
        {CurveBasis::catmull_rom, 8},
        {CurveBasis::bezier, 16}};
    for (const auto& [basis, points] : points_of_five_intervals) {
        EXPECT_EQ(control_points_of(basis, 5), points) << layout_of(basis).name;
        EXPECT_EQ(layout_of(basis).segments(points), 5u) << layout_of(basis).name;
    }
}

TEST(EmittedCurve, EveryBasisIsTheCurveThatTheCheckEvaluates) {
    // Two evaluations that share no code, one of them in floats: places below 8 cm by at
    // most four terms, each rounded by 2.4e-7 a few times.
    const Vec3 u(0.3, -0.8, 0.5);
    const int n = 7;
    for (const BasisLayout& layout : kBasisLayouts) {
        const Emitted emitted(helix_states(u, 0.5, n), 0.5, layout.basis, Vec3f(1, 2, 3));
        ASSERT_EQ(emitted.strand.segments(), std::size_t(n)) << layout.name;
        Eigen::AlignedBox3d hull;
        extend_by_hull(hull, layout.basis, emitted.curve.points, emitted.curve.tangents);
        for (int j = 0; j < n; ++j) {
            for (const float t : {0.0f, 0.3f, 0.5f, 1.0f}) {
                const Vec3 place = emitted.strand.position(j, t);
                const Vec3f in_floats = emitted_place(layout.basis, emitted.curve.points,
                                                      emitted.curve.tangents, j, t);
                EXPECT_LT((in_floats.cast<double>() - place).norm(), 5e-6)
                    << layout.name << ' ' << j << ' ' << t;
                EXPECT_LT(hull.exteriorDistance(place), 1e-12) << layout.name;
            }
        }
    }
}

TEST(EmittedCurve, BezierIsTheHermiteCurve) {
    const Vec3 u(0.3, -0.8, 0.5);
    const auto states = helix_states(u, 0.5, 6);
    const Emitted hermite(states, 0.5, CurveBasis::hermite),
        bezier(states, 0.5, CurveBasis::bezier);
    for (int j = 0; j < 6; ++j) {
        for (const double t : {0.0, 0.25, 0.5, 1.0}) {
            // The inner Bezier points, below 4 cm, are rounded to floats.
            EXPECT_LT(
                (hermite.strand.position(j, t) - bezier.strand.position(j, t)).norm(),
                1e-6);
        }
    }
}

}  // namespace
}  // namespace lancret
