// Single lobes, and the furnace by quadrature.

#include <gtest/gtest.h>

#include "render_test/sampling/sampling.h"
#include "tests/render_test/material/hair_bsdf_helpers.h"
#include "tests/render_test/statistics.h"

namespace lancret {
namespace {

/// The p-value of samples of one lobe against its M N.
double lobe_chance(const HairMaterial& m, float inclination, float h, int lobe, int count,
                   int fine, unsigned seed) {
    const HairModel model(m);
    const HairBsdf bsdf(model, viewer(inclination), h);
    float low = 0;
    for (int p = 0; p < lobe; ++p) low += LobeInspection::probability(bsdf, p);
    SphereBins bins(24, 48);
    Random random{std::mt19937(seed)};
    int drawn = 0;
    for (int i = 0; i < count; ++i) {
        // Within the share of the lobe, kept away from its ends by more than a rounding.
        const float pick =
            low + LobeInspection::probability(bsdf, lobe) * (0.001f + 0.998f * random());
        const float azimuth = random();
        const auto sample = bsdf.sample(pick, azimuth, random.pair());
        if (sample) bins.add(sample->direction), ++drawn;
    }
    EXPECT_EQ(drawn, count);
    auto expected = bins.integrals(
        [&](const Vec3f& d) { return LobeInspection::density(bsdf, lobe, d); }, fine);
    for (double& e : expected) e *= count;
    return pearson_chance(bins.counts, expected);
}

TEST(HairBsdf, SamplesOfEachLobeFollowItsOwnDensity) {
    // Twelve tests, each wrong once in 1000. R has a quarter of the others' variance: its
    // narrowest here, at beta 0.3, is 0.1 radian wide and contains 12 midpoints at 1/16
    // of a bin of 7.5 degrees.
    unsigned seed = 20;
    for (int lobe = 0; lobe < kHairLobes; ++lobe) {
        EXPECT_GT(lobe_chance(material(0.3f, 0.3f, 0.05f, 0.1f), 0.4f, 0.5f, lobe, 40000,
                              16, ++seed),
                  1e-3)
            << lobe;
        EXPECT_GT(lobe_chance(material(0.6f, 0.2f, -0.1f, 0), -1.2f, -0.9f, lobe, 40000,
                              16, ++seed),
                  1e-3)
            << lobe;
        EXPECT_GT(
            lobe_chance(material(1, 1, 0.2f, 0.5f), 0, 0.05f, lobe, 40000, 12, ++seed),
            1e-3)
            << lobe;
    }
}

TEST(HairBsdf, TheWholeIsTheSumOfItsLobes) {
    Random random{std::mt19937(33)};
    const HairModel model(material(0.4f, 0.3f, 0.05f, 0.2f));
    for (int i = 0; i < 200; ++i) {
        const HairBsdf bsdf(model, viewer(3 * random() - 1.5f), 2 * random() - 1);
        const Vec3f wi = uniform_sphere(random.pair());
        Vec3f value = Vec3f::Zero();
        float pdf = 0, probability = 0;
        for (int p = 0; p < kHairLobes; ++p) {
            value += LobeInspection::attenuation(bsdf, p) *
                     LobeInspection::density(bsdf, p, wi);
            pdf += LobeInspection::probability(bsdf, p) *
                   LobeInspection::density(bsdf, p, wi);
            probability += LobeInspection::probability(bsdf, p);
        }
        const BsdfValue at = bsdf.evaluate(wi);
        EXPECT_LE((value - at.value).norm(), 1e-6f * value.norm());
        EXPECT_NEAR(pdf, at.pdf, 1e-6f * pdf);
        EXPECT_NEAR(probability, 1, 1e-6f);
    }
}

TEST(HairBsdf, WhiteFurnaceHoldsAtEveryRoughnessAndTilt) {
    // By quadrature, not at random: midpoints over inclination and azimuth, for all
    // lobes. Without absorption the whole is their M N weighted by attenuations that sum
    // to one. The steps of pi / 1440 and 2 pi / 720 are at most a third of the narrowest
    // lobe's width: R at beta_m = 0.05 has sqrt(v) = 0.0094 (v = 0.25 (0.726 * 0.05 +
    // 0.812 * 0.0025)^2), and the logistic at 0.05 has s = 0.015. At the poles the error
    // of the rule is that of DensityIntegratesToOne with a step 2.4 times smaller, and M
    // reaches 1 / v there only if the lobe extends to the pole, which it does not for
    // these viewers.
    constexpr int kRows = 1440, kColumns = 720;
    for (const float beta : {0.05f, 0.1f, 0.2f, 0.4f, 0.7f, 1.0f}) {
        for (const float tilt : {-0.3f, 0.0f, 0.035f, 0.15f}) {
            const HairModel model(material(beta, beta, tilt, 0));
            const HairBsdf bsdf(model, viewer(0.5f), 0.3f);
            double sum = 0;
            for (int i = 0; i < kRows; ++i) {
                const double t = M_PI * ((i + 0.5) / kRows - 0.5);
                for (int j = 0; j < kColumns; ++j) {
                    const double a = 2 * M_PI * (j + 0.5) / kColumns;
                    const Vec3f wi(float(std::sin(t)), float(std::cos(t) * std::cos(a)),
                                   float(std::cos(t) * std::sin(a)));
                    sum += bsdf.evaluate(wi).value.x() * std::cos(t);
                }
            }
            EXPECT_NEAR(sum * 2 * M_PI * M_PI / kRows / kColumns, 1, 2e-4)
                << beta << ' ' << tilt;
        }
    }
}

TEST(HairBsdf, IsReciprocalOnlyAtEqualInclinations) {
    // f(wo, wi) cos(wi) with A of wo only, as published by Chiang et al.: swapping the
    // two changes A (docs/rendering.md). Without tilt and at equal inclinations and |h|
    // the model is reciprocal in M and N, so the ratio is that of A.
    const HairModel model(material(0.4f, 0.4f, 0, 1.0f));
    const auto f = [&](float to, float ti) {
        // wi in the plane of wo and the strand: both have the azimuth of z.
        const HairBsdf bsdf(model, viewer(to), 0.3f);
        return bsdf.evaluate(viewer(ti)).value.x() / std::cos(ti);
    };
    EXPECT_NEAR(f(0.5f, -0.5f) / f(-0.5f, 0.5f), 1, 1e-5);
    EXPECT_GT(std::abs(f(0.2f, 1.2f) / f(1.2f, 0.2f) - 1), 0.1);
}

}  // namespace
}  // namespace lancret
