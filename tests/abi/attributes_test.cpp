// Values of the attributes of points and strands.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "procedural/groom/groom_source.h"
#include "procedural/groom/ready_groom.h"
#include "tests/abi/plugin.h"

namespace lancret {
namespace {

constexpr lancret_u32 kAll = 255;
constexpr int kBases[] = {LANCRET_LINEAR, LANCRET_BSPLINE, LANCRET_CATMULL_ROM,
                          LANCRET_BEZIER, LANCRET_HERMITE};
constexpr float kEpsilon = std::numeric_limits<float>::epsilon();
/// The same for all bases, so that their points are at the same places of a strand.
constexpr int kIntervals = 24;
const std::string kSameIntervals =
    kSmallGroom + "intervals = " + std::to_string(kIntervals) + "\n";

/// Control points per interval, and before the root.
int step_of(int basis) { return basis == LANCRET_BEZIER ? 3 : 1; }
int before_of(int basis) {
    return basis == LANCRET_BSPLINE || basis == LANCRET_CATMULL_ROM ? 1 : 0;
}

Vec3f at(const std::vector<float>& from, int point) {
    return {from[4 * point], from[4 * point + 1], from[4 * point + 2]};
}

TEST(PluginAttributes, StrandsHaveTheValuesOfTheLibrary) {
    const auto context = make_context();
    const auto groom = opened(context.get(), kSmallGroom);
    GroomSource source;
    source.text = kSmallGroom;
    const ReadyGroom ready = make_ready_groom(read_groom_source(source).groom);
    const Binding& binding = ready.binding;
    const auto strands = expanded(groom.get(), make_options(LANCRET_LINEAR, kAll));
    ASSERT_EQ(strands.size(), binding.size());
    const std::size_t k = binding.neighbours;
    double random = 0;
    for (std::size_t i = 0; i < binding.size(); ++i) {
        const StrandArrays& s = strands.at(binding.roots.id(i));
        ASSERT_EQ(s.length, binding.lengths[i]);
        ASSERT_EQ(s.u, binding.roots.uvs[i].x());
        ASSERT_EQ(s.v, binding.roots.uvs[i].y());
        for (std::size_t g = 0; g < k; ++g) {
            ASSERT_EQ(s.guides[g], binding.guides[i * k + g]);
            ASSERT_EQ(s.weights[g], binding.weights[i * k + g]);
        }
        ASSERT_TRUE(s.random >= 0 && s.random < 1);
        random += s.random;
    }
    // The mean of 3000 uniform values is 1/2 within 5 standard deviations,
    // 5 sqrt(1/12/3000).
    EXPECT_NEAR(random / 3000, 0.5, 0.027);
}

TEST(PluginAttributes, ArcLengthsAreEvenFromRootToTip) {
    const auto context = make_context();
    const auto groom = opened(context.get(), kSameIntervals);
    for (const int basis : kBases) {
        const int step = step_of(basis), before = before_of(basis);
        for (const auto& [id, s] : expanded(groom.get(), make_options(basis, kAll))) {
            ASSERT_EQ(s.arc_lengths.size(),
                      std::size_t(step * kIntervals + 1 + 2 * before));
            for (std::size_t j = 0; j < s.arc_lengths.size(); ++j) {
                const double expected =
                    double(s.length) * (double(j) - before) / (step * kIntervals);
                // A quotient and a product, each rounded to half an epsilon.
                ASSERT_NEAR(s.arc_lengths[j], expected, std::abs(expected) * kEpsilon)
                    << basis << ' ' << j;
            }
        }
    }
}

TEST(PluginAttributes, TangentsAndNormalsAreThoseOfTheStrand) {
    const auto context = make_context();
    const auto groom = opened(context.get(), kSameIntervals);
    const auto hermite = expanded(groom.get(), make_options(LANCRET_HERMITE, kAll));
    for (const int basis : kBases) {
        const int step = step_of(basis), before = before_of(basis);
        for (const auto& [id, s] : expanded(groom.get(), make_options(basis, kAll))) {
            const StrandArrays& reference = hermite.at(id);
            const float segment = s.length / kIntervals;
            for (int i = 0; i <= kIntervals; ++i) {
                const int j = before + step * i;
                const Vec3f t = at(s.tangents, j), n = at(s.normals, j);
                const Vec3f along = at(reference.tangents, i) / segment;
                const bool derivative = basis == LANCRET_HERMITE;
                const float size = derivative ? segment : 1;
                // Frames are products of up to 24 rotations, whose elements are sums of
                // three products: orthonormal within some 24 * 4 half epsilons.
                constexpr float kFrame = 24 * 4 * kEpsilon / 2;
                ASSERT_NEAR(t.norm(), size, size * kFrame) << basis << ' ' << i;
                ASSERT_NEAR(n.norm(), 1, kFrame) << basis << ' ' << i;
                ASSERT_EQ(n, at(reference.normals, i)) << basis << ' ' << i;
                if (basis == LANCRET_BSPLINE) {
                    // The tangent of the spline itself at its knots.
                    const Vec3f knot = at(s.positions, j + 1) - at(s.positions, j - 1);
                    ASSERT_LT((t - knot.normalized()).norm(), kFrame) << i;
                    continue;
                }
                ASSERT_NEAR(t.dot(n) / size, 0, kFrame) << basis << ' ' << i;
                ASSERT_LT((t / size - along).norm(), kFrame) << basis << ' ' << i;
            }
        }
    }
}

TEST(PluginAttributes, HermiteTangentsAreTheDerivative) {
    const auto context = make_context();
    const auto groom = opened(context.get(), kSmallGroom + "intervals = 256\n");
    for (const auto& [id, s] :
         expanded(groom.get(), make_options(LANCRET_HERMITE, LANCRET_NORMALS))) {
        for (int i = 0; i < 256; ++i) {
            const Vec3f a = at(s.tangents, i), b = at(s.tangents, i + 1);
            const Vec3f chord = at(s.positions, i + 1) - at(s.positions, i);
            // For an arc of length h that turns by x about an axis, the component
            // perpendicular to the axis is h sin(axis, tangent) times cos(x / 2) for the
            // mean of the end tangents and times sinc(x / 2) for the chord, which differ
            // by x^2 / 12. The chords of tangent and normal give an upper bound for x.
            const float h = a.norm(), turn = (b - a).norm() / h;
            const float x =
                std::hypot(turn, (at(s.normals, i + 1) - at(s.normals, i)).norm());
            // Coordinates of up to 30 cm, each rounded to half an epsilon of 32.
            const float rounding = 2 * 16 * kEpsilon;
            ASSERT_LE((chord - (a + b) / 2).norm(), 1.1f * h * turn * x / 12 + rounding)
                << id << ' ' << i;
        }
    }
}

TEST(PluginAttributes, UnitScalesLengthsAndNothingElse) {
    const auto context = make_context();
    const auto groom = opened(context.get(), kSmallGroom);
    for (const int basis : {LANCRET_BSPLINE, LANCRET_HERMITE}) {
        auto options = make_options(basis, kAll);
        const auto in_cm = expanded(groom.get(), options);
        options.unit = 0.5f;  // half a cm: exactly twice the numbers
        const auto in_halves = expanded(groom.get(), options);
        const auto twice = [](std::vector<float> values) {
            for (float& x : values) x *= 2;
            return values;
        };
        for (const auto& [id, a] : in_cm) {
            const StrandArrays& b = in_halves.at(id);
            ASSERT_EQ(twice(a.positions), b.positions);
            ASSERT_EQ(twice(a.arc_lengths), b.arc_lengths);
            ASSERT_EQ(2 * a.length, b.length);
            // Derivatives scale as lengths, directions do not.
            ASSERT_EQ(basis == LANCRET_HERMITE ? twice(a.tangents) : a.tangents,
                      b.tangents);
            ASSERT_EQ(a.normals, b.normals);
            ASSERT_EQ(a.weights, b.weights);
        }
    }
}

}  // namespace
}  // namespace lancret
