#include "guides/base/hash.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace lancret {
namespace {

// The first value is the first output of SplitMix64 from seed 0, published by its
// authors; the others were computed with Python's integers.
static_assert(mix_bits(0x9e3779b97f4a7c15u) == 0xe220a8397b1dcdafu);
static_assert(hash_bits(0, 0, 0) == 0x238275bc38fcbe91u);
static_assert(hash_bits(1, 2, 3) == 0x6ae515c1c0ac7e37u);
static_assert(hash_bits(~0ull, ~0ull, ~0ull) == 0x40aa389ba7cc36a4u);

TEST(Hash, NumbersAreBelowOne) {
    EXPECT_EQ(unit_double(~0ull), 1 - 0x1p-53);
    EXPECT_EQ(unit_float(~0ull), 1 - 0x1p-24f);
    EXPECT_EQ(unit_double(0), 0);
    EXPECT_EQ(unit_double(1ull << 63), 0.5);
    EXPECT_EQ(unit_float(1ull << 63), 0.5f);
}

TEST(Hash, EachInputBitChangesHalfOfTheOutput) {
    // 192 input bits times 100 hashes: each mean of 64 * 100 fair bits has a standard
    // deviation of 0.4 bits around 32; 5 of them fail by chance once in 9,000 runs.
    for (int bit = 0; bit < 192; ++bit) {
        int changed = 0;
        for (std::uint64_t i = 0; i < 100; ++i) {
            std::uint64_t in[3] = {i, 7 * i, 3};
            const std::uint64_t before = hash_bits(in[0], in[1], in[2]);
            in[bit / 64] ^= 1ull << bit % 64;
            changed += std::popcount(before ^ hash_bits(in[0], in[1], in[2]));
        }
        EXPECT_NEAR(changed / 100.0, 32, 5 * 0.4) << bit;
    }
}

TEST(Hash, NeighbouringStrandsAreUncorrelated) {
    const int n = 100000;
    double sum = 0, product = 0;
    for (std::uint64_t i = 0; i < n; ++i) {
        const double x = unit_double(hash_bits(5, i, 0)) - 0.5;
        sum += x;
        product += x * (unit_double(hash_bits(5, i + 1, 0)) - 0.5);
    }
    // Standard deviations of the means: sqrt(1/12 / n) and 1/12 / sqrt(n).
    EXPECT_LT(std::abs(sum / n), 5 * std::sqrt(1.0 / 12 / n));
    EXPECT_LT(std::abs(product / n), 5.0 / 12 / std::sqrt(n));
}

}  // namespace
}  // namespace lancret
