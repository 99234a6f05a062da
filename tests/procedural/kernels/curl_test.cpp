#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "procedural/blend/anchor.h"
#include "procedural/check/strand.h"
#include "procedural/kernels/strand_kernels.h"
#include "tests/procedural/kernels/every_target.h"
#include "tests/procedural/made_hair.h"

namespace lancret {
namespace {

using test::kHalfUlp;
using test::MadeHair;
using test::on_every_target;

/// Maximum error of a frame after n intervals, radian: the quaternion's product, the step
/// and the normalisation round about 12 times each, and a rotation is twice its
/// quaternion; the errors of n steps add up.
double frame_error(int n) { return 2 * 12 * kHalfUlp * (n + 2); }

/// Factor by which anchoring increases a spine's error: the turn is the quaternion (b, S
/// x G) with b = |S||G| + S.G + e and changes by the spines' errors over b; the tilt
/// changes by twice their errors over kShort.
double anchor_factor(Blend blend, const Binding& binding,
                     const GuideProfiles<double>& profiles, std::size_t i) {
    const BoundChild<double> bound = bound_child(binding, profiles, i);
    std::vector<HelixState<double>> states(profiles.count + 1);
    if (blend == Blend::detail) {
        blend_nearest<double>(bound.child(), profiles, states);
    } else {
        blend_option1<double>(bound.child(), profiles, states);
    }
    const Anchor<double> anchor = anchor_of<double>(bound.child(), profiles, states);
    double largest = 0;
    for (int place = 0; place <= profiles.count; ++place) {
        const auto turns = turns_at(anchor, bound.child(), profiles, place);
        largest = std::max(largest, 2 / turns.to_goal.cosine);
    }
    return 1 + largest + 2 / 0.05;
}

/// Maximum error of a frame, radian, and of a place, as a fraction of the length.
double strand_error(Blend blend, const Binding& binding,
                    const GuideProfiles<double>& profiles, std::size_t i) {
    const double plain = frame_error(profiles.count);
    if (blend == Blend::nearest) return plain;
    // Option 1's kappa is a quotient that loses digits if normals oppose: a hundredth of
    // the weight left costs two of seven digits.
    const double option1 = 1e-4;
    if (blend == Blend::option1) return option1;
    const double factor = anchor_factor(blend, binding, profiles, i);
    return factor * (blend == Blend::detail ? plain : option1);
}

std::vector<Blend> curl_blends() {
    std::vector<Blend> out;
    for (const BlendTraits& traits : blends()) {
        if (traits.kernel == BlendKernel::curl) out.push_back(traits.blend);
    }
    return out;
}

class CurlKernel : public testing::TestWithParam<Blend> {};

TEST_P(CurlKernel, EqualsTheScalarStrandOnEveryTarget) {
    for (const int n : {1, 3, 14, 41}) {
        const MadeHair hair(203, n, 3, 4, 4, n < 3 ? 0.03 : 0.3);
        const auto fine = guide_profiles<double>(hair.standing.guides, n);
        std::vector<HelixState<double>> exact(n + 1);
        std::vector<HelixState<float>> fast(203 * (n + 1));
        on_every_target([&] {
            synthesize({hair.binding, hair.profiles, hair.kernel(GetParam()), GetParam()},
                       0, 203, fast);
            for (std::size_t i = 0; i < 203; ++i) {
                synthesize_child<double>(hair.binding, fine, GetParam(), i, exact);
                const double bound = strand_error(GetParam(), hair.binding, fine, i);
                for (int j = 0; j <= n; ++j) {
                    const HelixState<float>& state = fast[i * (n + 1) + j];
                    EXPECT_LT((state.frame.cast<double>() - exact[j].frame).norm(),
                              std::sqrt(2) * bound);
                    EXPECT_LT((state.position.cast<double>() - exact[j].position).norm(),
                              bound * hair.binding.lengths[i])
                        << "child " << i << ", place " << j;
                }
            }
        });
    }
}

TEST_P(CurlKernel, LengthsAreExactAndFramesOrthonormal) {
    // Turns of up to about 2.5 radians per interval: below half a turn, so that lengths
    // can be measured from frames and places.
    for (const double curvature : {0.01, 0.3, 0.5}) {
        const MadeHair hair(500, 12, 5, 4, 4, curvature);
        std::vector<HelixState<float>> states(500 * 13);
        on_every_target([&] {
            synthesize({hair.binding, hair.profiles, hair.kernel(GetParam()), GetParam()},
                       0, 500, states);
            for (std::size_t i = 0; i < 500; ++i) {
                const auto strand = std::span(states).subspan(i * 13, 13);
                double length = 0;
                for (int j = 0; j < 12; ++j) {
                    length += measured_interval(strand[j], strand[j + 1]).length;
                }
                // The tolerance of `check`; each chord is accurate to a few half ulps of
                // the places at its ends.
                EXPECT_NEAR(length / hair.binding.lengths[i], 1, 1e-5);
                EXPECT_LT(orthogonality_error(strand), 1e-6);
            }
        });
    }
}

TEST_P(CurlKernel, ControlPointsAreMadeFromItsPlaces) {
    for (const int n : {1, 2, 14}) {
        const MadeHair hair(50, n, 6, 4, 4, n < 3 ? 0.03 : 0.3);
        const std::size_t count = std::size_t(n) + 1;
        std::vector<HelixState<float>> states(50 * count);
        on_every_target([&] {
            synthesize({hair.binding, hair.profiles, hair.kernel(GetParam()), GetParam()},
                       0, 50, states);
            for (const CurveBasis basis : {CurveBasis::bspline, CurveBasis::hermite}) {
                const Curves curves = expand(hair.binding, hair.profiles,
                                             {.blend = GetParam(), .basis = basis});
                const std::size_t points = curves.points_of(0);
                std::vector<Point4f> expected(points), tangents(points);
                for (std::size_t i = 0; i < 50; ++i) {
                    const auto places = std::span(states).subspan(i * count, count);
                    const Vec3f& root = hair.binding.roots.positions[i];
                    const float ds = hair.binding.lengths[i] / float(n);
                    if (basis == CurveBasis::bspline) {
                        bspline_points(places, ds, root, {}, expected);
                    } else {
                        hermite_points(places, ds, root, {}, expected, tangents);
                    }
                    // The outermost points sum (6 + 5 * 76 / 36) places, two of them
                    // beyond the end, at up to 2 ds on a helix with the error of two
                    // frames over ds.
                    const double bound = 17 * (frame_error(2) * 2 * ds +
                                               8 * kHalfUlp * hair.binding.lengths[i]) +
                                         2 * kHalfUlp * root.norm();
                    for (std::size_t j = 0; j < points; ++j) {
                        const Point4f& p = curves.points[i * points + j];
                        EXPECT_LT((p.xyz() - expected[j].xyz()).norm(), bound);
                        EXPECT_NEAR(p.w, expected[j].w, 1e-9);
                        if (basis == CurveBasis::bspline) continue;
                        const Point4f& t = curves.tangents[i * points + j];
                        EXPECT_LT((t.xyz() - tangents[j].xyz()).norm(), bound);
                        EXPECT_EQ(t.w, tangents[j].w);
                    }
                }
            }
        });
    }
}

TEST_P(CurlKernel, StrandsThatTurnTooFarUseTheScalarBlend) {
    // 14 cm in two intervals of 7 cm, at up to 3 radians per cm.
    const MadeHair hair(40, 2, 7, 4, 2, 3.0);
    on_every_target([&] {
        const Curves fast = expand(hair.binding, hair.profiles, {.blend = GetParam()});
        Curves scalar;
        expand(hair.binding, hair.profiles, {}, {.blend = GetParam()}, scalar);
        std::size_t same = 0;
        for (std::size_t i = 0; i < 40; ++i) {
            same += std::memcmp(&fast.points[i * 5], &scalar.points[i * 5],
                                5 * sizeof(Point4f)) == 0;
        }
        // Most guides turn by more than 6.28 radians.
        EXPECT_GT(same, 20u);
    });
}

TEST_P(CurlKernel, OpposedNormalsUseTheScalarBlend) {
    MadeHair hair(64, 8, 8);
    for (std::size_t i = 0; i < 64; i += 3) {
        hair.binding.roots.normals[i] = -Vec3f::UnitZ();
    }
    on_every_target([&] {
        const Curves fast = expand(hair.binding, hair.profiles, {.blend = GetParam()});
        Curves scalar;
        expand(hair.binding, hair.profiles, {}, {.blend = GetParam()}, scalar);
        for (std::size_t i = 0; i < 64; i += 3) {
            EXPECT_EQ(std::memcmp(&fast.points[i * 11], &scalar.points[i * 11],
                                  11 * sizeof(Point4f)),
                      0);
        }
        for (const Point4f& p : fast.points.span()) {
            EXPECT_TRUE(p.xyz().allFinite());
        }
    });
}

INSTANTIATE_TEST_SUITE_P(Blends, CurlKernel, testing::ValuesIn(curl_blends()),
                         [](const auto& blend) {
                             std::string name(blend_name(blend.param));
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace lancret
