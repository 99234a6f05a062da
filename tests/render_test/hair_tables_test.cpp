// The figures of docs/hair_bsdf.md: furnace and chi-square by roughness and tilt.

#include <gtest/gtest.h>

#include <cstdio>

#include "tests/render_test/hair_bsdf_helpers.h"
#include "tests/render_test/statistics.h"

namespace lancret {
namespace {

constexpr float kInclinations[] = {0, 0.7f, -1.3f}, kOffsets[] = {-0.9f, 0, 0.6f};

/// The value over the sphere by midpoints, `rows` by `columns`, even in both angles.
double integral(const HairBsdf& bsdf, int rows, int columns) {
    double sum = 0;
    for (int i = 0; i < rows; ++i) {
        const double t = M_PI * ((i + 0.5) / rows - 0.5);
        double row = 0;
        for (int j = 0; j < columns; ++j) {
            const double a = 2 * M_PI * (j + 0.5) / columns;
            row +=
                bsdf.evaluate(Vec3f(float(std::sin(t)), float(std::cos(t) * std::cos(a)),
                                    float(std::cos(t) * std::sin(a))))
                    .value.x();
        }
        sum += row * std::cos(t);
    }
    return sum * 2 * M_PI * M_PI / rows / columns;
}

double chance(const HairBsdf& bsdf, int samples, int fine, unsigned seed) {
    SphereBins bins(24, 48);
    Random random{std::mt19937(seed)};
    for (int i = 0; i < samples; ++i) bins.add(draw(bsdf, random).value().direction);
    auto expected =
        bins.integrals([&](const Vec3f& d) { return bsdf.evaluate(d).pdf; }, fine);
    for (double& e : expected) e *= samples;
    return pearson_chance(bins.counts, expected);
}

TEST(SlowHairTables, WhiteFurnaceByRoughnessAndTilt) {
    // Steps are a quarter of the narrowest lobe's width (TT, sqrt(v) / 2) and of the
    // logistic's 1.8 s or less: the rule's own error is below 1e-8, but for the ends at
    // the poles, where the cosine has a slope: step^2 / 24 times M there, at most 1 / v
    // = (0.5 / width)^2 of R and TRT; with the step a quarter of the width 6.5e-4 / 4 if
    // all light went there; and the logarithms' rounding, 2e-5 at 0.05.
    std::printf(
        "largest of |1 - furnace| of 9 viewers\n  beta   tilt -0.3      0  0.035    "
        "0.16\n");
    for (const float beta : {0.05f, 0.1f, 0.2f, 0.3f, 0.6f, 1.0f}) {
        const double width = (0.726 * beta + 0.812 * beta * beta) / 2;
        const double s = 0.6267 * (0.265 * beta + 1.194 * beta * beta);
        const int rows = std::max(64, int(4 * M_PI / width));
        const int columns = std::max(64, int(8 * M_PI / std::min(1.8 * s, 1.0)));
        std::printf("%6.2f", double(beta));
        for (const float tilt : {-0.3f, 0.0f, 0.035f, 0.16f}) {
            const HairModel model(material(beta, beta, tilt, 0));
            double most = 0;
            for (const float inclination : kInclinations)
                for (const float h : kOffsets)
                    most = std::max(
                        most,
                        std::abs(1 - integral(HairBsdf(model, viewer(inclination), h),
                                              rows, columns)));
            EXPECT_LT(most, 2e-4) << beta << ' ' << tilt;
            std::printf("  %.1e", most);
        }
        std::printf("\n");
    }
}

TEST(SlowHairTables, ChiSquareByRoughnessAndTilt) {
    // 216 tests of 2e5 samples: the least chance of 9 is shown. One below 0.01 / 216 is a
    // fault, and comes by chance once in 100 runs.
    std::printf("least chance of 9 viewers\n  beta   tilt -0.3   0   0.035   0.16\n");
    unsigned seed = 100;
    for (const float beta : {0.05f, 0.1f, 0.2f, 0.3f, 0.6f, 1.0f}) {
        std::printf("%6.2f", double(beta));
        for (const float tilt : {-0.3f, 0.0f, 0.035f, 0.16f}) {
            const HairModel model(material(beta, beta, tilt, 0.2f));
            double least = 1;
            for (const float inclination : kInclinations)
                for (const float h : kOffsets)
                    least =
                        std::min(least, chance(HairBsdf(model, viewer(inclination), h),
                                               200000, beta < 0.15f ? 48 : 16, ++seed));
            EXPECT_GT(least, 0.01 / 216) << beta << ' ' << tilt;
            std::printf("  %5.3f", least);
        }
        std::printf("\n");
    }
}

}  // namespace
}  // namespace lancret
