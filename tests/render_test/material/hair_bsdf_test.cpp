#include "render_test/material/hair_bsdf.h"

#include <gtest/gtest.h>

#include "render_test/sampling/sampling.h"
#include "tests/render_test/material/hair_bsdf_helpers.h"
#include "tests/render_test/statistics.h"

namespace lancret {
namespace {

/// Albedo, by importance sampling.
Mean albedo(const HairBsdf& bsdf, int count, Random& random) {
    Mean mean;
    for (int i = 0; i < count; ++i) {
        const auto sample = draw(bsdf, random);
        mean.add(sample ? sample->at.value.x() / sample->at.pdf : 0);
    }
    return mean;
}

TEST(HairBsdf, WhiteFurnaceByUniformDirectionsScattersAllLight) {
    Random random{std::mt19937(1)};
    int tries = 0, outside = 0;
    for (const float beta_m : {0.1f, 0.3f, 0.6f, 1.0f}) {
        for (const float beta_n : {0.1f, 0.4f, 1.0f}) {
            for (const float tilt : {0.0f, 0.05f, -0.2f}) {
                for (const float inclination : {0.0f, 0.7f, -1.4f}) {
                    const HairModel model(material(beta_m, beta_n, tilt, 0));
                    Mean mean;
                    for (int i = 0; i < 6000; ++i) {
                        const HairBsdf bsdf(model, viewer(inclination), 2 * random() - 1);
                        const BsdfValue at = bsdf.evaluate(uniform_sphere(random.pair()));
                        mean.add(at.value.x() * 4 * M_PI);
                    }
                    ++tries;
                    // The mean of rare large values is skewed with few samples: kSigmas
                    // bounds the sum of all cases, three sigmas most single ones.
                    outside += std::abs(mean.value() - 1) > 3 * mean.error();
                }
            }
        }
    }
    // A probability of 0.003 to 0.02 each, by skewness: more than 10 of 108 occur once in
    // 1e4.
    EXPECT_EQ(tries, 108);
    EXPECT_LE(outside, 10);
}

TEST(HairBsdf, WhiteFurnaceBySamplingHasWeightOneForEverySample) {
    // Without absorption the lobes' attenuations sum to one, and the density is the
    // value: the weight is one up to the rounding of four products and sums in float, 16
    // half-ulps of 6e-8.
    Random random{std::mt19937(2)};
    for (const float beta : {0.01f, 0.1f, 0.3f, 1.0f}) {
        for (int i = 0; i < 2000; ++i) {
            const HairModel model(material(beta, beta, 0.3f * random() - 0.15f, 0));
            const HairBsdf bsdf(model, viewer(3.1f * random() - 1.55f), 2 * random() - 1);
            const auto sample = draw(bsdf, random);
            ASSERT_TRUE(sample);
            EXPECT_NEAR(sample->at.value.x() / sample->at.pdf, 1, 1e-6);
        }
    }
}

TEST(HairBsdf, DensityIntegratesToOne) {
    // Midpoints on 600 inclinations and 300 azimuths: a tenth of the narrowest lobe
    // (sqrt(v) / 2 = 0.04) and a third of the logistic (s = 0.063), where the error of
    // the rule on a smooth bump is exp(-2 (pi width / step)^2) < 1e-9. At the poles the
    // cosine ends with a slope: by Euler and Maclaurin step^2 / 24 times M there, for R
    // at most 1 / v = 153, is 1.7e-4.
    constexpr int kRows = 600, kColumns = 300;
    for (const float beta_m : {0.1f, 0.4f, 1.0f}) {
        for (const float inclination : {0.0f, -0.6f, 1.3f}) {
            for (const float h : {-0.95f, 0.2f, 0.7f}) {
                const HairModel model(material(beta_m, 0.2f, 0.06f, 0.3f));
                const HairBsdf bsdf(model, viewer(inclination), h);
                double sum = 0;
                for (int i = 0; i < kRows; ++i) {
                    for (int j = 0; j < kColumns; ++j) {
                        const double t = M_PI * ((i + 0.5) / kRows - 0.5);
                        const double a = 2 * M_PI * (j + 0.5) / kColumns;
                        const Vec3f wi(float(std::sin(t)),
                                       float(std::cos(t) * std::cos(a)),
                                       float(std::cos(t) * std::sin(a)));
                        sum += bsdf.evaluate(wi).pdf * std::cos(t);
                    }
                }
                EXPECT_NEAR(sum * 2 * M_PI * M_PI / kRows / kColumns, 1, 2e-4)
                    << beta_m << ' ' << inclination << ' ' << h;
            }
        }
    }
}

double sampling_chance(const HairMaterial& m, float inclination, float h, int count,
                       int fine, unsigned seed) {
    const HairModel model(m);
    const HairBsdf bsdf(model, viewer(inclination), h);
    SphereBins bins(24, 48);
    Random random{std::mt19937(seed)};
    for (int i = 0; i < count; ++i) bins.add(draw(bsdf, random).value().direction);
    auto expected =
        bins.integrals([&](const Vec3f& d) { return bsdf.evaluate(d).pdf; }, fine);
    for (double& e : expected) e *= count;
    return pearson_chance(bins.counts, expected);
}

TEST(HairBsdf, SampledDirectionsFollowTheDensity) {
    // Four tests, each wrong once in 1000.
    EXPECT_GT(
        sampling_chance(material(0.2f, 0.3f, 0.05f, 0.2f), 0.3f, 0.4f, 50000, 16, 1),
        1e-3);
    EXPECT_GT(sampling_chance(material(0.5f, 0.2f, 0.1f, 0), -0.9f, -0.8f, 50000, 16, 2),
              1e-3);
    EXPECT_GT(sampling_chance(material(1, 1, 0, 1), 0, 0, 50000, 12, 3), 1e-3);
    EXPECT_GT(
        sampling_chance(material(0.3f, 0.3f, -0.1f, 0.1f), 1.45f, 0.99f, 50000, 16, 4),
        1e-3);
}

TEST(SlowHairBsdf, SampledDirectionsFollowTheDensityEverywhere) {
    // 60 tests of a million samples; in all, one is wrong by chance once in 100 runs.
    unsigned seed = 10;
    for (const float beta : {0.1f, 0.3f, 0.6f, 1.0f}) {
        for (const float inclination : {0.0f, 0.8f, -1.2f}) {
            for (const float h : {-0.99f, -0.5f, 0.0f, 0.6f, 1.0f}) {
                EXPECT_GT(sampling_chance(material(beta, beta, 0.06f, 0.2f), inclination,
                                          h, 1000000, beta < 0.2f ? 48 : 24, ++seed),
                          0.01 / 60)
                    << beta << ' ' << inclination << ' ' << h;
            }
        }
    }
}

TEST(HairBsdf, ImportanceAndUniformSamplingAgree) {
    Random random{std::mt19937(5)};
    for (const float sigma_a : {0.1f, 1.0f, 5.0f}) {
        const HairModel model(material(0.5f, 0.6f, 0.05f, sigma_a));
        const HairBsdf bsdf(model, viewer(0.4f), -0.3f);
        Mean uniform;
        for (int i = 0; i < 100000; ++i) {
            uniform.add(bsdf.evaluate(uniform_sphere(random.pair())).value.x() * 4 *
                        M_PI);
        }
        const Mean importance = albedo(bsdf, 100000, random);
        EXPECT_NEAR(uniform.value(), importance.value(),
                    kSigmas * std::hypot(uniform.error(), importance.error()));
    }
}

TEST(HairBsdf, MorePigmentScattersLessLight) {
    // With the same random numbers for each. The lobes' probabilities change, so values
    // are compared beyond their errors.
    Mean last;
    last.add(1);
    for (const float eumelanin : {0.1f, 0.3f, 1.0f, 3.0f, 8.0f}) {
        HairMaterial m;
        m.eumelanin = eumelanin;
        const HairModel model(m);
        Random random{std::mt19937(6)};
        Mean mean;
        for (int i = 0; i < 20000; ++i) {
            const HairBsdf bsdf(model, viewer(0.2f), 2 * random() - 1);
            const auto sample = draw(bsdf, random);
            ASSERT_TRUE(sample);
            mean.add(sample->at.value.x() / sample->at.pdf);
        }
        EXPECT_LT(mean.value(), last.value() - kSigmas * mean.error()) << eumelanin;
        last = mean;
    }
    EXPECT_GT(last.value(), 0.04);  // what the surface reflects is left at any pigment
}

TEST(HairBsdf, NothingIsNanAtTheEdges) {
    for (const float beta : {0.01f, 0.3f, 1.0f}) {
        for (const float sigma_a : {0.0f, 1e-6f, 1.0f, 1e4f}) {
            for (const float x : {-1.0f, -0.99999f, 0.0f, 1e-20f, 1.0f}) {
                for (const float h : {-1.0f, -0.9999999f, 0.0f, 1.0f}) {
                    const HairModel model(material(beta, beta, 0.05f, sigma_a));
                    const Vec3f wo(x, 0, std::sqrt(1 - x * x));
                    const HairBsdf bsdf(model, wo, h);
                    for (const Vec3f& wi : {wo, Vec3f(-wo), Vec3f(1, 0, 0),
                                            Vec3f(-1, 0, 0), Vec3f(0, 1, 0)}) {
                        const BsdfValue at = bsdf.evaluate(wi);
                        ASSERT_TRUE(at.value.allFinite() && std::isfinite(at.pdf));
                        ASSERT_TRUE(at.value.minCoeff() >= 0 && at.pdf >= 0);
                    }
                    for (const float r : {0.0f, 0.5f, 0x1.fffffep-1f}) {
                        const auto sample = bsdf.sample(r, r, {r, r});
                        if (!sample) continue;
                        ASSERT_TRUE(sample->direction.allFinite());
                        ASSERT_NEAR(sample->direction.norm(), 1, 1e-5);
                        // A weight is at most one: the colour of a lobe over its
                        // luminance, grey here.
                        ASSERT_LE(sample->at.value.x(), sample->at.pdf * 1.00001f);
                    }
                }
            }
        }
    }
}

TEST(HairBsdf, SurfaceHighlightLeansTowardsTheRoot) {
    // Everything but R is absorbed. R's mean direction is mirrored about a normal that
    // leans to the root by the tilt, so its inclination is minus twice the tilt. The
    // spread reduces the mean of sin by at most v / 2 of itself: v = 0.0065.
    const float tilt = 0.1f;
    const HairModel model(material(0.1f, 0.3f, tilt, 1e4f));
    const HairBsdf bsdf(model, viewer(0), 0.3f);
    Random random{std::mt19937(8)};
    Mean mean;
    for (int i = 0; i < 20000; ++i) mean.add(draw(bsdf, random).value().direction.x());
    EXPECT_NEAR(mean.value(), -std::sin(2 * tilt),
                kSigmas * mean.error() + 0.0065 * std::sin(2 * tilt));
}

TEST(HairBsdf, OffsetToOneSideReflectsToThatSide) {
    // At h the normal of the surface has the component h along y: R is reflected to 2
    // asin(h) from the viewer, and the logistic is symmetric about it.
    const float h = 0.5f;
    const HairModel model(material(0.1f, 0.05f, 0, 1e4f));
    const HairBsdf bsdf(model, viewer(0), h);
    Random random{std::mt19937(9)};
    Mean angle;
    for (int i = 0; i < 20000; ++i) {
        const Vec3f d = draw(bsdf, random).value().direction;
        angle.add(std::atan2(d.y(), d.z()));
    }
    EXPECT_NEAR(angle.value(), 2 * std::asin(h), kSigmas * angle.error());
}

TEST(HairBsdf, FresnelIsThatOfGlassAtNormalIncidenceAndOneAtGrazing) {
    EXPECT_NEAR(fresnel_dielectric(1, 1.5f), 0.04f, 1e-6);
    EXPECT_FLOAT_EQ(fresnel_dielectric(0, 1.5f), 1);
}

TEST(HairColour, AbsorptionOfAColourComesBackFromTheFit) {
    // Chiang's fit at beta_n = 0.3: sqrt(sigma) = ln(c) / 5.8714...
    const double b = 0.3;
    const double fit = 5.969 - 0.215 * b + 2.532 * b * b - 10.73 * b * b * b +
                       5.574 * std::pow(b, 4) + 0.245 * std::pow(b, 5);
    const Vec3f sigma = sigma_a_of_colour(Vec3f(0.9f, 0.5f, 0.1f), 0.3f);
    EXPECT_NEAR(sigma.y(), std::pow(std::log(0.5) / fit, 2), 1e-7);
    EXPECT_LT(sigma.x(), sigma.y());
    EXPECT_LT(sigma.y(), sigma.z());
}

TEST(HairColour, ColourOfAnAbsorptionIsTheInverse) {
    for (const float beta : {0.1f, 0.3f, 0.8f}) {
        for (const Vec3f& c : {Vec3f(0.9f, 0.5f, 0.1f), Vec3f(0.02f, 0.3f, 0.99f)}) {
            // exp(-fit sqrt(sigma)): the exponent is at most 4, its rounding 5e-7.
            const Vec3f back = colour_of_sigma_a(sigma_a_of_colour(c, beta), beta);
            EXPECT_LT((back - c).cwiseAbs().maxCoeff(), 1e-6f);
        }
    }
}

TEST(HairColour, RefusesWhatIsOutOfRange) {
    HairMaterial m;
    m.beta_m = 0;
    EXPECT_THROW(HairModel{m}, std::invalid_argument);
    m = {};
    m.eumelanin = -1;
    EXPECT_THROW(HairModel{m}, std::invalid_argument);
    m = {};
    m.colour = Vec3f(0.5f, 2, 0);
    EXPECT_THROW(HairModel{m}, std::invalid_argument);
    m = {};
    m.eta = 1;
    EXPECT_THROW(HairModel{m}, std::invalid_argument);
}

TEST(HairMaterial, RoughenedHairKeepsItsAbsorption) {
    HairMaterial m;
    m.colour = Vec3f(0.6f, 0.3f, 0.1f);
    m.beta_m = 0.2f, m.beta_n = 0.7f;
    const HairMaterial wide = roughened(m, 0.5f);
    EXPECT_EQ(wide.beta_m, 0.5f);
    EXPECT_EQ(wide.beta_n, 0.7f);
    // The absorption of a colour depends on beta_n: it remains that of the original
    // material.
    EXPECT_EQ(sigma_a_of(wide), sigma_a_of(m));
    EXPECT_EQ(sigma_a_of(roughened(m, 0.9f)), sigma_a_of(m));
}

}  // namespace
}  // namespace lancret
