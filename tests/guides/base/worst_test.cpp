#include "guides/base/worst.h"

#include <gtest/gtest.h>

namespace lancret {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(WorstOf, IsTheLarger) {
    EXPECT_EQ(worst_of(1.0, 2.0), 2);
    EXPECT_EQ(worst_of(2.0, 1.0), 2);
    EXPECT_EQ(worst_of(kInfinity, 1.0), kInfinity);
}

TEST(WorstOf, ANaNIsInfiniteWhereverItComes) {
    double worst = 0;
    for (const double error : {1.0, kNaN, 3.0}) worst = worst_of(worst, error);
    EXPECT_EQ(worst, kInfinity);
    EXPECT_EQ(worst_of(kNaN, 1.0), kInfinity);
    EXPECT_EQ(nan_as_infinity(kNaN), kInfinity);
    EXPECT_EQ(nan_as_infinity(-2.0), -2);
}

}  // namespace
}  // namespace lancret
