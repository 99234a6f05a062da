#include "guides/motion/monotone_cubic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lancret {
namespace {

CubicValue at(const std::vector<double>& x, const std::vector<double>& y,
              const std::vector<double>& m, std::size_t i, double where) {
    return hermite_cubic(x[i], x[i + 1], y[i], y[i + 1], m[i], m[i + 1], where);
}

TEST(MonotoneCubic, NeverLeavesTheRangeOfTwoNeighbouringKeys) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> step(0.1, 5), jump(-3, 3);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<double> x{0}, y{0};
        for (int i = 0; i < 8; ++i) {
            x.push_back(x.back() + step(random));
            // Sometimes a plateau, sometimes a cliff.
            const double d = jump(random);
            y.push_back(y.back() + (i % 3 == 0 ? 0 : i % 3 == 1 ? d : 100 * d));
        }
        const auto m = monotone_slopes(x, y);
        EXPECT_EQ(m.front(), 0);
        EXPECT_EQ(m.back(), 0);
        for (std::size_t i = 0; i + 1 < x.size(); ++i) {
            const double low = std::min(y[i], y[i + 1]), high = std::max(y[i], y[i + 1]);
            // Round-off of a few operations on numbers of this size.
            const double slack = 1e-14 * (1 + std::abs(low) + std::abs(high));
            double last = y[i];
            for (int k = 0; k <= 50; ++k) {
                const double v = at(x, y, m, i, x[i] + (x[i + 1] - x[i]) * k / 50).value;
                EXPECT_GE(v, low - slack);
                EXPECT_LE(v, high + slack);
                EXPECT_GE((v - last) * (y[i + 1] - y[i]), -slack * (high - low));
                last = v;
            }
        }
    }
}

TEST(MonotoneCubic, ReproducesAStraightLineAwayFromItsEnds) {
    const std::vector<double> x{0, 1, 3, 4, 7}, y{1, 3, 7, 9, 15};
    const auto m = monotone_slopes(x, y);
    for (std::size_t i = 1; i < 3; ++i) {
        const CubicValue v = at(x, y, m, i, x[i] + 0.3);
        EXPECT_NEAR(v.value, y[i] + 0.6, 1e-14);
        EXPECT_NEAR(v.slope, 2, 1e-14);
        EXPECT_NEAR(v.bend, 0, 1e-13);
    }
}

TEST(MonotoneCubic, DerivativesAreThoseOfTheCubic) {
    // y = x^3 - x on [1, 3]: y' = 3 x^2 - 1, y'' = 6 x.
    for (const double x : {1.0, 1.7, 2.5, 3.0}) {
        const CubicValue v = hermite_cubic(1, 3, 0, 24, 2, 26, x);
        EXPECT_NEAR(v.value, x * x * x - x, 1e-13);
        EXPECT_NEAR(v.slope, 3 * x * x - 1, 1e-13);
        EXPECT_NEAR(v.bend, 6 * x, 1e-13);
    }
}

}  // namespace
}  // namespace lancret
