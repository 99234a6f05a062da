#include "procedural/roots/density.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "procedural/check/strand.h"
#include "procedural/chunk/chunked_groom.h"
#include "tests/procedural/small_groom.h"

namespace lancret {
namespace {

constexpr double kDensities[] = {0.001, 0.01, 0.1, 0.5, 0.9, 0.95, 0.999, 1};

std::vector<std::uint32_t> numbers(std::uint32_t count) {
    std::vector<std::uint32_t> out(count);
    std::iota(out.begin(), out.end(), 0u);
    return out;
}

/// Relative standard deviation of the summed width of `strands` strands of one length:
/// sqrt((integral of w^2 - 1) / strands). The square of a fade from 1 to 0 over 2h has
/// the integral 2h / 3.
double area_deviation(double density, std::size_t strands) {
    const double h = std::min(kFade * density, 1 - density);
    const double square = (density - h + 2 * h / 3) / (density * density);
    return std::sqrt(std::max(0.0, square - 1) / double(strands));
}

TEST(Density, WidthsKeepTheAreaInTheMean) {
    // The midpoint rule is exact for a linear function; w has two corners and at most one
    // step, which at d = 1 lies on a cell's border.
    for (const double d : kDensities) {
        constexpr int kCells = 1 << 20;
        double sum = 0;
        for (int i = 0; i < kCells; ++i) sum += width_at((i + 0.5) / kCells, d);
        // A corner adds at most slope / 2 times the cell's width squared: 1 / (0.2 d^2)
        // n^-2.
        EXPECT_NEAR(sum / kCells, 1, 1e-9 + 5 / (d * d) / (double(kCells) * kCells)) << d;
    }
}

TEST(Density, OneKeepsEveryStrandUnchanged) {
    std::vector<std::uint32_t> ids = numbers(10000);
    const std::vector<float> widths = prune(ids, 3, 1);
    EXPECT_EQ(ids, numbers(10000));
    EXPECT_TRUE(std::ranges::all_of(widths, [](float w) { return w == 1; }));
}

TEST(Density, ASmallerSetIsASubset) {
    std::vector<std::uint32_t> more = numbers(100000);
    for (const double d : {1.0, 0.7, 0.1, 0.09, 0.01, 0.0001}) {
        std::vector<std::uint32_t> kept = numbers(100000);
        prune(kept, 5, d);
        EXPECT_TRUE(std::ranges::includes(more, kept)) << d;
        EXPECT_LE(kept.size(), more.size());
        more = kept;
    }
    EXPECT_GT(more.size(), 0u);
}

TEST(Density, KeepsTheFractionOfStrandsAndTheirArea) {
    // Both are sums over independent ranks; the tolerance is five standard deviations.
    constexpr std::uint32_t kStrands = 200000;
    for (const double d : kDensities) {
        std::vector<std::uint32_t> ids = numbers(kStrands);
        const std::vector<float> widths = prune(ids, 11, d);
        const double share = std::min(1.0, d + std::min(kFade * d, 1 - d));
        EXPECT_NEAR(double(ids.size()), share * kStrands,
                    5 * std::sqrt(kStrands * share * (1 - share)) + 1e-9)
            << d;
        double area = 0;
        for (const float w : widths) area += w;
        EXPECT_NEAR(area / kStrands, 1, 5 * area_deviation(d, kStrands) + 1e-6) << d;
    }
}

TEST(Density, DeviationIsThatOfTheWidths) {
    for (const double d : kDensities) {
        constexpr int kCells = 1 << 20;
        double square = 0;
        for (int i = 0; i < kCells; ++i) {
            const double w = width_at((i + 0.5) / kCells, d);
            square += w * w / kCells;
        }
        const double deviation = std::sqrt(std::max(0.0, square - 1) / 100);
        EXPECT_NEAR(area_deviation(d, 100), deviation, 1e-3 * deviation + 1e-6) << d;
    }
}

TEST(Density, WidthIsContinuousInTheDensity) {
    // dw/dd is largest in the fade: with h = kFade d it is (r / d^2) / 2h + w / d, below
    // (1.1 / 0.2 + 1) / d^2; with h = 1 - d it is at most (1 - r) / 2 (1 - d)^2 + ...,
    // and 1 - r < 2 (1 - d) there: below 1 / (1 - d) + 1 / d^2 for any rank.
    for (const double rank : {0.0, 0.003, 0.2, 0.7, 0.95, 0.9999}) {
        double d = 0.002;
        while (d < 1 - 1e-6) {
            const double step = 1e-4 * std::min(d, 1 - d);
            const double change = std::abs(width_at(rank, d + step) - width_at(rank, d));
            EXPECT_LE(change, step * (6.5 / (d * d) + 1 / (1 - d - step)) + 1e-12)
                << rank << ' ' << d;
            d += std::max(step, 1e-5);
        }
        EXPECT_NEAR(width_at(rank, 1 - 1e-9), 1, 1e-8);
    }
}

TEST(Density, LodIsOneUntilThereAreMoreStrandsThanRequested) {
    EXPECT_EQ(lod_density(1e6, 1000, 1), 1);
    EXPECT_EQ(lod_density(100, 1000, 1), 0.1);
    EXPECT_EQ(lod_density(100, 1000, 5), 0.5);
    EXPECT_EQ(lod_density(0, 1000, 1), kMinDensity);
    EXPECT_EQ(lod_density(std::nan(""), 1000, 1), 1);
    EXPECT_EQ(lod_density(1, 0, 1), 1);
}

GroomSettings groom_of_density(double density) {
    GroomSettings groom =
        test::small_groom({.made = 40, .guides = 12, .segments = 4, .strands = 3000});
    groom.density = density;
    return groom;
}

/// Width times length, as if drawn from the side, summed over the strands.
double area_of(const Curves& curves) {
    double out = 0;
    for (std::size_t i = 0; i < curves.strands; ++i) {
        const EmittedStrand strand = emitted_strand(curves, i);
        const std::size_t n = strand.segments();
        out += strand.length() * (strand.points[1].w + strand.points[n + 1].w);
    }
    return out;
}

TEST(Density, AGroomGrowsTheSameStrandsWiderAndKeepsTheArea) {
    const ReadyGroom all = make_ready_groom(groom_of_density(1));
    const Curves whole = expand(all.binding, rest_guides(all), all.groom.expand);
    const double area = area_of(whole);
    std::vector<std::uint32_t> place(whole.strands);  // by id
    for (std::uint32_t i = 0; i < whole.strands; ++i) place[whole.id_of(i)] = i;
    for (const double d : {0.5, 0.1, 0.02}) {
        const ReadyGroom some = make_ready_groom(groom_of_density(d));
        const Curves curves = expand(some.binding, rest_guides(some), some.groom.expand);
        ASSERT_EQ(curves.ids.size(), curves.strands);
        for (std::uint32_t i = 0; i < curves.strands; ++i) {
            const std::uint32_t id = curves.id_of(i);
            const double w = width_at(strand_rank(some.groom.seed, id), d);
            ASSERT_EQ(curves.points_of(i), whole.points_of(place[id]));
            for (std::uint32_t j = 0; j < curves.points_of(i); ++j) {
                const Point4f& own = whole.points[whole.first_point(place[id]) + j];
                const Point4f& wide = curves.points[curves.first_point(i) + j];
                ASSERT_EQ(wide.xyz(), own.xyz()) << id;
                ASSERT_NEAR(wide.w, w * own.w, 1e-6 * wide.w) << id;
            }
        }
        // Lengths vary by up to 1.4 : 1 and add to the variance of widths w as
        // E w^2 E L^2 / (E L)^2 <= 1.03 E w^2: less than 1.1 times the deviation.
        EXPECT_NEAR(area_of(curves) / area, 1, 5 * 1.1 * area_deviation(d, 3000)) << d;
    }
}

}  // namespace
}  // namespace lancret
