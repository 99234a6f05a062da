#include <gtest/gtest.h>

#include "procedural/check/strand.h"
#include "procedural/kernels/strand_kernels.h"
#include "tests/procedural/kernels/every_target.h"
#include "tests/procedural/made_hair.h"

namespace lancret {
namespace {

using test::kHalfUlp;
using test::MadeHair;
using test::on_every_target;

Vec3 place(const Point4f& p) { return p.xyz().cast<double>(); }

/// A control point of a child relative to its root, summed in double from the rows that
/// the kernel reads.
struct Sum {
    Vec3 place = Vec3::Zero();
    double size = 0;  ///< sum of the sizes of its terms
};

Sum blended(const MadeHair& hair, const KernelGuides& guides, std::size_t i,
            std::size_t j) {
    const std::size_t k = hair.binding.neighbours;
    double weight = 0, length = 0;
    Sum sum;
    for (std::size_t n = i * k; n < (i + 1) * k; ++n) {
        const std::size_t g = hair.binding.guides[n];
        const float* row = &guides.points[g * 3 * guides.point_stride + j];
        const Vec3 c(row[0], row[guides.point_stride], row[2 * guides.point_stride]);
        const double w = hair.binding.weights[n];
        sum.place += w * c;
        sum.size += w * c.norm();
        weight += w;
        length += w * hair.profiles.lengths[g];
    }
    const double scale = hair.binding.lengths[i] * weight / length;
    sum.place *= scale / weight;
    sum.size *= scale / weight;
    return sum;
}

/// Sum of the absolute factors of places in a control point. Places beyond an end sum 7
/// and 17 places, so c[0] sums (54 + 10 * 8 + 18) / 36 < 4.3, c[1] 2.3, and the
/// outermost, 6 p - 4 c[0] - c[1], at most this.
constexpr double kMaxTaps = 26;

TEST(PositionKernel, SumsItsGuidesControlPointsOnEveryTarget) {
    for (const int intervals : {1, 2, 7, 13, 14, 29, 45}) {
        const MadeHair hair(100, intervals, 1);
        const KernelGuides guides =
            kernel_guides(hair.profiles, hair.standing.normals, Blend::position);
        on_every_target([&] {
            const Curves curves =
                expand(hair.binding, hair.profiles, {.blend = Blend::position});
            const std::size_t points = curves.points_of(0);
            for (std::size_t at = 0; at < curves.points.size(); ++at) {
                const Sum sum = blended(hair, guides, at / points, at % points);
                const Vec3 root =
                    hair.binding.roots.positions[at / points].cast<double>();
                const Vec3 off = place(curves.points[at]) - root - sum.place;
                // Roundings of a factor: its weight over the sum of four (4), the length
                // (4), scale and product (2); of the sum: a product and an addition per
                // guide. The last addition rounds the result.
                const double bound =
                    18 * kHalfUlp * sum.size + kHalfUlp * (root + sum.place).norm();
                EXPECT_LT(off.cwiseAbs().maxCoeff(), bound) << "point " << at;
            }
        });
    }
}

TEST(PositionKernel, AGuidesRowsAreItsScalarControlPoints) {
    for (const int intervals : {1, 2, 14, 29}) {
        const MadeHair hair(1, intervals, 2);
        const KernelGuides guides =
            kernel_guides(hair.profiles, hair.standing.normals, Blend::position);
        std::vector<HelixState<float>> states(intervals + 1);
        std::vector<Point4f> points(intervals + 3);
        for (std::size_t g = 0; g < guides.size; ++g) {
            const Mat3f& turn = hair.profiles.root_frames[g];
            for (int i = 0; i <= intervals; ++i) {
                states[i] = {turn * hair.profiles.frame(g, i),
                             turn * hair.profiles.position(g, i)};
            }
            const float length = hair.profiles.lengths[g];
            bspline_points(states, length / float(intervals), Vec3f::Zero(), {}, points,
                           Ends::parabola);
            for (std::size_t j = 0; j < points.size(); ++j) {
                const float* row = &guides.points[g * 3 * guides.point_stride + j];
                const Vec3 c(row[0], row[guides.point_stride],
                             row[2 * guides.point_stride]);
                // Places are accurate to 4 half ulps of the length, and so is each of the
                // two roundings; the outermost points sum kMaxTaps of them.
                const double bound = length * kMaxTaps * 8 * kHalfUlp;
                EXPECT_LT((place(points[j]) - c).norm(), bound) << g << ", " << j;
            }
        }
    }
}

TEST(PositionKernel, EqualsTheScalarStrand) {
    const MadeHair hair(300, 14, 3);
    Curves scalar;
    expand(hair.binding, hair.profiles, {}, {.blend = Blend::position}, scalar);
    on_every_target([&] {
        const Curves fast =
            expand(hair.binding, hair.profiles, {.blend = Blend::position});
        for (std::size_t i = 0; i < 300; ++i) {
            for (std::size_t j = 0; j < 17; ++j) {
                // Both round places of up to the strand's length about 12 times, and the
                // root's position.
                const double taps = j < 3 || j > 13 ? kMaxTaps : 76.0 / 36;
                const double bound =
                    kHalfUlp * (2 * 12 * taps * hair.binding.lengths[i] + 4 * 32);
                const std::size_t at = i * 17 + j;
                EXPECT_LT((place(fast.points[at]) - place(scalar.points[at])).norm(),
                          bound);
                EXPECT_EQ(fast.points[at].w, scalar.points[at].w);
            }
        }
    });
}

TEST(PositionKernel, BeginsAndEndsWithTheStrand) {
    const MadeHair hair(200, 9, 4);
    std::vector<HelixState<double>> exact(10);
    const auto profiles = guide_profiles<double>(hair.standing.guides, 9);
    on_every_target([&] {
        const Curves curves =
            expand(hair.binding, hair.profiles, {.blend = Blend::position});
        for (std::size_t i = 0; i < 200; ++i) {
            synthesize_child<double>(hair.binding, profiles, Blend::position, i, exact);
            const EmittedStrand strand = emitted_strand(curves, i);
            const Vec3 root = hair.binding.roots.positions[i].cast<double>();
            // Three control points of up to 32 cm, with 18 half ulps each.
            const double bound = 3 * 18 * kHalfUlp * 32;
            EXPECT_LT((strand.position(0, 0) - root).norm(), bound);
            EXPECT_LT((strand.position(8, 1) - root - exact[9].position).norm(), bound);
        }
    });
}

TEST(NumberSegments, NumbersThemOnEveryTarget) {
    on_every_target([] {
        for (const std::uint32_t intervals : {1u, 2u, 3u, 7u, 15u, 16u, 17u, 40u}) {
            for (const std::uint32_t more : {1u, 3u}) {
                for (const std::size_t count : {1, 5, 70}) {
                    const std::size_t first = 11;
                    std::vector<std::uint32_t> numbers(count * intervals + 1, 7);
                    number_segments(first, count, intervals + more, intervals,
                                    numbers.data(), count == 5);
                    for (std::size_t at = 0; at < count * intervals; ++at) {
                        ASSERT_EQ(
                            numbers[at],
                            first + at / intervals * (intervals + more) + at % intervals);
                    }
                    EXPECT_EQ(numbers.back(), 7u);
                }
            }
        }
    });
}

}  // namespace
}  // namespace lancret
