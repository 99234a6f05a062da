// The figures of docs/hair_bsdf.md: furnace and chi-square by roughness and tilt.

#include <gtest/gtest.h>

#include <cstdio>

#include "sim/segment/gauss_legendre.h"
#include "tests/render_test/material/hair_bsdf_helpers.h"
#include "tests/render_test/statistics.h"

namespace lancret {
namespace {

constexpr float kInclinations[] = {0, 0.7f, -1.3f}, kOffsets[] = {-0.9f, 0, 0.6f};

/// The integral of the value over the sphere: Gauss's rule of 16 points on `panels` of
/// the inclination, and `columns` uniform azimuths.
double integral(const HairBsdf& bsdf, int panels, int columns) {
    const GaussRule rule = gauss_rule(16);
    double sum = 0;
    for (int i = 0; i < panels * 16; ++i) {
        const double t = M_PI * ((i / 16 + rule.nodes[i % 16]) / panels - 0.5);
        double row = 0;
        for (int j = 0; j < columns; ++j) {
            const double a = 2 * M_PI * (j + 0.5) / columns;
            row +=
                bsdf.evaluate(Vec3f(float(std::sin(t)), float(std::cos(t) * std::cos(a)),
                                    float(std::cos(t) * std::sin(a))))
                    .value.x();
        }
        sum += rule.weights[i % 16] * row * std::cos(t);
    }
    return sum * 2 * M_PI * M_PI / panels / columns;
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
    // A panel is at most four widths of the narrowest lobe (TT, sqrt(v) / 2), for which
    // 16 points leave 1e-10. Azimuths step by a quarter of the logistic's 1.8 s, which
    // leaves exp(-2 pi^2 / (1.8 / 4)) of its peak. The rest is rounding: 2e-5 root mean
    // square of a value in single precision at 0.05 (docs/hair_bsdf.md), less for the
    // mean of many.
    std::printf(
        "largest of |1 - furnace| of 9 viewers\n  beta   tilt -0.3      0  0.035    "
        "0.16\n");
    for (const float beta : {0.05f, 0.1f, 0.2f, 0.3f, 0.6f, 1.0f}) {
        const double width = (0.726 * beta + 0.812 * beta * beta) / 2;
        const double s = 0.6267 * (0.265 * beta + 1.194 * beta * beta);
        const int panels = std::max(4, int(M_PI / 4 / width) + 1);
        const int columns = std::max(64, int(8 * M_PI / std::min(1.8 * s, 1.0)));
        std::printf("%6.2f", double(beta));
        for (const float tilt : {-0.3f, 0.0f, 0.035f, 0.16f}) {
            const HairModel model(material(beta, beta, tilt, 0));
            double most = 0;
            for (const float inclination : kInclinations) {
                for (const float h : kOffsets) {
                    most = std::max(
                        most,
                        std::abs(1 - integral(HairBsdf(model, viewer(inclination), h),
                                              panels, columns)));
                }
            }
            EXPECT_LT(most, 2e-5) << beta << ' ' << tilt;
            std::printf("  %.1e", most);
        }
        std::printf("\n");
    }
}

TEST(SlowHairTables, ChiSquareByRoughnessAndTilt) {
    // 216 tests of 2e5 samples; the minimum p-value of 9 is printed. One below 0.01 / 216
    // is a fault, and occurs by chance once in 100 runs.
    std::printf("least chance of 9 viewers\n  beta   tilt -0.3   0   0.035   0.16\n");
    unsigned seed = 100;
    for (const float beta : {0.05f, 0.1f, 0.2f, 0.3f, 0.6f, 1.0f}) {
        std::printf("%6.2f", double(beta));
        for (const float tilt : {-0.3f, 0.0f, 0.035f, 0.16f}) {
            const HairModel model(material(beta, beta, tilt, 0.2f));
            double least = 1;
            for (const float inclination : kInclinations) {
                for (const float h : kOffsets) {
                    least =
                        std::min(least, chance(HairBsdf(model, viewer(inclination), h),
                                               200000, beta < 0.15f ? 48 : 16, ++seed));
                }
            }
            EXPECT_GT(least, 0.01 / 216) << beta << ' ' << tilt;
            std::printf("  %5.3f", least);
        }
        std::printf("\n");
    }
}

}  // namespace
}  // namespace lancret
