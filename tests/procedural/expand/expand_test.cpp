#include "procedural/expand/expand.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cstring>

#include "guides/helix/super_helix.h"
#include "procedural/check/strand.h"
#include "tests/procedural/expand/cubic_error.h"
#include "tests/procedural/kernels/every_target.h"
#include "tests/procedural/made_hair.h"

namespace lancret {
namespace {

using test::MadeHair;

bool same_bytes(const Curves& a, const Curves& b) {
    const auto same = [](const auto& x, const auto& y) {
        return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.bytes()) == 0;
    };
    return same(a.points, b.points) && same(a.segments, b.segments) &&
           (a.tangents.size() == 0 ? b.tangents.size() == 0
                                   : same(a.tangents, b.tangents));
}

TEST(Expand, SameStrandsForAnyThreadCountAndGrain) {
    const MadeHair hair(300, 12, 1);
    test::on_every_target([&] {
        for (const Blend blend : {Blend::detail, Blend::option1, Blend::position}) {
            for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
                ExpandSettings settings{.blend = blend, .basis = basis};
                const Curves one = expand(hair.binding, hair.profiles, settings);
                for (const int threads : {1, 2, 5}) {
                    tbb::global_control control(
                        tbb::global_control::max_allowed_parallelism, threads);
                    for (const std::uint32_t grain : {1u, 7u, 256u, 10000u}) {
                        settings.grain = grain;
                        EXPECT_TRUE(same_bytes(
                            one, expand(hair.binding, hair.profiles, settings)))
                            << threads << " threads, grain " << grain;
                    }
                }
            }
        }
    });
}

TEST(Expand, BuffersAreReused) {
    const MadeHair hair(90, 12, 1), other(90, 12, 2), longer(90, 20, 3);
    Curves curves;
    for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
        const ExpandSettings settings{.basis = basis};
        const auto grow = [&](const MadeHair& made) {
            expand(made.binding, made.profiles, made.kernel(settings.blend), settings,
                   curves);
        };
        grow(hair);
        const Point4f* const memory = curves.points.data();
        grow(other);
        EXPECT_EQ(curves.points.data(), memory);
        EXPECT_TRUE(same_bytes(curves, expand(other.binding, other.profiles, settings)));
        grow(longer);
        EXPECT_TRUE(
            same_bytes(curves, expand(longer.binding, longer.profiles, settings)));
    }
}

TEST(Expand, AStrandDoesNotDependOnHowManyThereAre) {
    const MadeHair few(50, 12, 2), many(500, 12, 2);
    const Curves a = expand(few.binding, few.profiles, {});
    const Curves b = expand(many.binding, many.profiles, {});
    ASSERT_EQ(a.strands, 50u);
    ASSERT_EQ(b.strands, 500u);
    EXPECT_EQ(std::memcmp(a.points.data(), b.points.data(), a.points.bytes()), 0);
}

TEST(Expand, NumbersItsSegments) {
    const MadeHair hair(9, 8, 3);
    for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
        const Curves curves = expand(hair.binding, hair.profiles, {.basis = basis});
        const std::uint32_t points = basis == CurveBasis::bspline ? 11 : 9;
        EXPECT_EQ(curves.classes[0].segments, 8u);
        EXPECT_EQ(curves.points_of(0), points);
        ASSERT_EQ(curves.points.size(), 9 * points);
        ASSERT_EQ(curves.tangents.size(), basis == CurveBasis::hermite ? 9 * points : 0u);
        ASSERT_EQ(curves.segments.size(), 72u);
        for (std::uint32_t i = 0; i < 72; ++i) {
            EXPECT_EQ(curves.segments[i], i / 8 * points + i % 8);
            EXPECT_EQ(curves.place_of(i).strand, i / 8);
        }
    }
}

TEST(Expand, AStrandBeginsOnItsRoot) {
    const MadeHair hair(300, 12, 4);
    for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
        const Curves curves = expand(hair.binding, hair.profiles, {.basis = basis});
        for (std::size_t i = 0; i < 300; ++i) {
            const Vec3 begin = emitted_strand(curves, i).position(0, 0);
            // Three control points below 16 cm, each rounded by at most 2^-21 cm.
            EXPECT_LT((begin - hair.binding.roots.positions[i].cast<double>()).norm(),
                      3 * 4.8e-7);
        }
    }
}

TEST(Expand, RadiiTaperEvenlyFromRootToTip) {
    const MadeHair hair(3, 10, 5);
    for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
        const Curves curves = expand(hair.binding, hair.profiles,
                                     {.basis = basis, .taper = {0.01f, 0.002f}});
        const int before = basis == CurveBasis::bspline ? 1 : 0;
        for (std::uint32_t i = 0; i < 3; ++i) {
            for (std::uint32_t j = 0; j < curves.points_of(0); ++j) {
                // A B-spline of evenly spaced values is linear, so radii are those at
                // places.
                const std::size_t point = i * curves.points_of(0) + j;
                EXPECT_NEAR(curves.points[point].w, 0.01 - 0.0008 * (int(j) - before),
                            2e-9);
                if (basis == CurveBasis::hermite) {
                    EXPECT_NEAR(curves.tangents[point].w, -0.0008, 1e-10);
                }
            }
        }
    }
    // Beyond a tip of zero width the radius is not negative.
    const Curves fine = expand(hair.binding, hair.profiles, {.taper = {0.01f, 0}});
    for (const Point4f& p : fine.points.span()) EXPECT_GE(p.w, 0);
}

/// The largest distance of the emitted curve of a guide of one helix from the guide, cm.
double cubic_error(const Guides& guides, std::size_t g, int intervals, CurveBasis basis) {
    return test::cubic_error(guides.curvatures[g], guide_length(guides, g) / intervals,
                             basis);
}

/// The error of a place in single precision: a frame is accurate to 5e-7, so a place to
/// 5e-7 of its arc length, and numbers up to 32 cm are rounded by 2e-6.
double float_error(double length) { return 5e-7 * length + 4e-6; }

TEST(Expand, AChildOfOneGuideIsThatGuide) {
    const int n = 24;
    const auto standing = test::standing_guides(40, 1, 6, 0.5);
    const Binding binding = bind(test::guide_roots(standing), standing.guides,
                                 standing.normals, {.neighbours = 1});
    const auto profiles = guide_profiles<float>(standing.guides, n);
    for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
        const Curves curves = expand(binding, profiles, {.basis = basis});
        for (std::size_t g = 0; g < 40; ++g) {
            const double length = guide_length(standing.guides, g);
            const double limit =
                cubic_error(standing.guides, g, n, basis) + float_error(length);
            for (int j = 0; j < n; ++j) {
                for (const double t : {0.0, 0.3, 0.5, 0.8, 1.0}) {
                    const HelixState<double> exact =
                        state_at(super_helix(standing.guides, g), length * (j + t) / n);
                    const Vec3 off =
                        emitted_strand(curves, g).position(j, t) - exact.position;
                    EXPECT_LT(off.norm(), limit) << "guide " << g << " at " << j + t;
                }
            }
        }
    }
}

TEST(Expand, HermiteAndBsplineAreTheSameStrand) {
    const int n = 16;
    const MadeHair hair(200, n, 7, 1, 1);
    const Curves b = expand(hair.binding, hair.profiles, {});
    const Curves h = expand(hair.binding, hair.profiles, {.basis = CurveBasis::hermite});
    for (std::size_t i = 0; i < 200; ++i) {
        const std::size_t g = hair.binding.guides[i];
        // Both lie on the inner side: they differ by at most the farther of the two.
        const double limit =
            std::max(cubic_error(hair.standing.guides, g, n, CurveBasis::bspline),
                     cubic_error(hair.standing.guides, g, n, CurveBasis::hermite)) +
            2 * float_error(hair.binding.lengths[i]);
        for (int j = 0; j < n; ++j) {
            for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
                EXPECT_LT((emitted_strand(b, i).position(j, t) -
                           emitted_strand(h, i).position(j, t))
                              .norm(),
                          limit);
            }
        }
    }
}

TEST(Expand, DoubleAndFloatSynthesisAgree) {
    const MadeHair hair(100, 16, 8);
    const auto fine = guide_profiles<double>(hair.standing.guides, 16);
    std::vector<HelixState<double>> exact(17);
    std::vector<HelixState<float>> fast(17);
    for (std::size_t i = 0; i < 100; ++i) {
        for (const Blend blend : {Blend::option1, Blend::position}) {
            synthesize_child<double>(hair.binding, fine, blend, i, exact);
            synthesize_child<float>(hair.binding, hair.profiles, blend, i, fast);
            const double length = hair.binding.lengths[i];
            // The blended kappa is a quotient that loses digits where normals cancel: if
            // a hundredth of its weight is left, two of seven digits are lost.
            EXPECT_LT((exact[16].position - fast[16].position.cast<double>()).norm(),
                      1e-4 * length)
                << "child " << i << ", " << blend_name(blend);
        }
    }
}

TEST(Expand, AnEmptyBindingGivesNoStrands) {
    const auto standing = test::standing_guides(3, 2, 9);
    const Binding binding = bind({}, standing.guides, standing.normals, {});
    const Curves curves = expand(binding, guide_profiles<float>(standing.guides, 4), {});
    EXPECT_EQ(curves.strands, 0u);
    EXPECT_EQ(curves.points.size(), 0u);
}

}  // namespace
}  // namespace lancret
