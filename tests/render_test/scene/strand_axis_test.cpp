#include "render_test/scene/strand_axis.h"

#include <gtest/gtest.h>

#include <random>

namespace lancret {
namespace {

/// One strand of random control points: four segments.
Curves random_strand(CurveBasis basis) {
    const bool hermite = basis == CurveBasis::hermite;
    Curves curves;
    curves.basis = basis;
    curves.add_class(1, 4);
    curves.points = Buffer<Point4f>(curves.point_count());
    curves.tangents = Buffer<Point4f>(hermite ? 5 : 0);
    curves.segments = Buffer<std::uint32_t>(4);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0, 1);
    for (Buffer<Point4f>* buffer : {&curves.points, &curves.tangents}) {
        for (Point4f& p : buffer->span()) {
            p = {unit(random), unit(random), unit(random), unit(random)};
        }
    }
    for (std::uint32_t j = 0; j < 4; ++j) curves.segments[j] = j;
    return curves;
}

TEST(StrandAxis, SegmentsJoinWithTheirDerivatives) {
    for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
        const Curves curves = random_strand(basis);
        for (std::uint32_t j = 0; j + 1 < 4; ++j) {
            const AxisPoint end = axis_point(curves, j, 1);
            const AxisPoint start = axis_point(curves, j + 1, 0);
            EXPECT_LT((end.value - start.value).norm(), 1e-6f);
            EXPECT_LT((end.derivative - start.derivative).norm(), 2e-6f);
        }
    }
}

TEST(StrandAxis, HermiteEndsAreThePointsAndTangents) {
    const Curves curves = random_strand(CurveBasis::hermite);
    const AxisPoint at = axis_point(curves, 2, 0);
    EXPECT_LT((at.value.head<3>() - curves.points[2].xyz()).norm(), 1e-7f);
    EXPECT_LT((at.derivative.head<3>() - curves.tangents[2].xyz()).norm(), 1e-7f);
    EXPECT_FLOAT_EQ(at.value.w(), curves.points[2].w);
}

TEST(StrandAxis, BsplineEndsAreTheMeansOfTheirThreePoints) {
    const Curves curves = random_strand(CurveBasis::bspline);
    const Vec3f a = curves.points[1].xyz(), b = curves.points[2].xyz(),
                c = curves.points[3].xyz();
    const AxisPoint at = axis_point(curves, 1, 0);
    EXPECT_LT((at.value.head<3>() - (a + 4 * b + c) / 6).norm(), 1e-6f);
    EXPECT_LT((at.derivative.head<3>() - (c - a) / 2).norm(), 1e-6f);
}

TEST(StrandAxis, DerivativeMatchesFiniteDifferences) {
    for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
        const Curves curves = random_strand(basis);
        for (const float u : {0.125f, 0.5f, 0.8f}) {
            // Central differences: round-off 2e-7 / 2^-6, and step^2 / 6 of a third
            // derivative below 6 * 4 in sum (differences of numbers within one).
            const float step = 0x1p-7f;
            const Eigen::Vector4f slope = (axis_point(curves, 1, u + step).value -
                                           axis_point(curves, 1, u - step).value) /
                                          (2 * step);
            EXPECT_LT((slope - axis_point(curves, 1, u).derivative).norm(),
                      2e-7f / step + step * step / 6 * 24);
        }
    }
}

}  // namespace
}  // namespace lancret
