#include "render_test/material/strand_section.h"

#include <gtest/gtest.h>

#include "render_test/sampling/sampling.h"
#include "tests/render_test/material/hair_bsdf_helpers.h"
#include "tests/render_test/statistics.h"

namespace lancret {
namespace {

constexpr float kInclinations[] = {0, 0.7f, -1.3f}, kOffsets[] = {-0.95f, -0.3f, 0, 0.7f};

/// The difference of two angles, 0 to pi.
double apart(double a, double b) { return std::abs(std::remainder(a - b, 2 * M_PI)); }

TEST(StrandSection, IsAsWideAsItsAxesShow) {
    EXPECT_FLOAT_EQ((StrandSection{0.6f, 0}.half_width()), 1);
    EXPECT_FLOAT_EQ((StrandSection{0.6f, kPif / 2}.half_width()), 0.6f);
    // In between, the support of the ellipse: sqrt(cos^2 + 0.36 sin^2).
    EXPECT_FLOAT_EQ((StrandSection{0.6f, kPif / 4}.half_width()), std::sqrt(0.68f));
}

TEST(StrandSection, PathsOfACircleAreThoseOfTheClosedForm) {
    // phi = pi / 2 - 2 gamma_o + p (2 gamma_t + pi), the chord 2 cos gamma_t, one Fresnel
    // term [Marschner et al. 2003]. About twenty roundings of 6e-8, at offsets where the
    // arc sine multiplies them by 1 / sqrt(1 - 0.95^2) = 3.2.
    for (const float turn : {0.0f, 1.0f, -2.5f}) {
        for (const float inclination : kInclinations) {
            for (const float h : kOffsets) {
                const float eta = 1.55f, s = std::sin(inclination),
                            c = std::cos(inclination);
                const float bravais = std::sqrt(eta * eta - s * s) / c;
                const SectionPaths paths = section_paths({1, turn}, h, c, bravais, eta);
                const double gamma_o = std::asin(h), gamma_t = std::asin(h / bravais);
                const float f = fresnel_dielectric(c * std::sqrt(1 - h * h), eta);
                for (int p = 0; p < 3; ++p) {
                    EXPECT_LT(apart(paths.azimuth[p],
                                    M_PI / 2 - 2 * gamma_o + p * (2 * gamma_t + M_PI)),
                              1e-5)
                        << p << ' ' << h;
                    EXPECT_NEAR(paths.fresnel[p], f, 1e-5);
                }
                for (const float chord : paths.chord) {
                    EXPECT_NEAR(chord, 2 * std::cos(gamma_t), 1e-5);
                }
            }
        }
    }
}

TEST(StrandSection, ALightOnAnAxisGoesStraightThrough) {
    // Along the major axis R is reflected back, TT continues straight, and TRT comes
    // back. pi / 2 is off by 4e-8 in float, and each of three intersections at a tip of
    // curvature 4 multiplies that by up to 1 + 2 * 4: 3e-5.
    const SectionPaths paths = section_paths({0.5f, kPif / 2}, 0, 1, 1.55f, 1.55f);
    EXPECT_LT(apart(paths.azimuth[0], M_PI / 2), 3e-5);
    EXPECT_LT(apart(paths.azimuth[1], -M_PI / 2), 3e-5);
    EXPECT_LT(apart(paths.azimuth[2], M_PI / 2), 3e-5);
    EXPECT_NEAR(paths.chord[0], 2, 1e-6);
    EXPECT_NEAR((section_paths({0.5f, 0}, 0, 1, 1.55f, 1.55f).chord[0]), 1, 1e-6);
}

TEST(StrandSection, IsMirroredWithItsViewer) {
    for (const float angle : {0.3f, 1.2f}) {
        for (const float h : {0.2f, 0.8f}) {
            const SectionPaths a = section_paths({0.6f, angle}, h, 0.8f, 1.8f, 1.55f);
            const SectionPaths b = section_paths({0.6f, -angle}, -h, 0.8f, 1.8f, 1.55f);
            for (int p = 0; p < 3; ++p) {
                EXPECT_NEAR(a.fresnel[p], b.fresnel[p], 1e-5);
                if (p > 0 && a.fresnel[p] == 1) continue;
                EXPECT_LT(apart(a.azimuth[p] - M_PI / 2, M_PI / 2 - b.azimuth[p]), 1e-5);
            }
        }
    }
}

TEST(StrandSection, ACircleGivesTheSameBits) {
    const HairModel model(material(0.3f, 0.3f, 0.035f, 0.3f));
    Random random{std::mt19937(1)};
    for (int i = 0; i < 200; ++i) {
        const Vec3f wo = viewer(3 * random() - 1.5f), wi = uniform_sphere(random.pair());
        const float h = 2 * random() - 1;
        const BsdfValue plain = HairBsdf(model, model.sigma_a, wo, h).evaluate(wi);
        const BsdfValue circle =
            HairBsdf(model, model.sigma_a, wo, h, {1, random()}).evaluate(wi);
        EXPECT_EQ(plain.value, circle.value);
        EXPECT_EQ(plain.pdf, circle.pdf);
    }
}

TEST(StrandSection, NearACircleItIsNearIt) {
    // Azimuths change by at most twice the turn of the normals at three points, 3 (1 -
    // aspect) each times 1 / sqrt(1 - h^2) <= 3.3, against a logistic of scale 0.12: the
    // value changes by less than 2 * 9 * 3.3 / 0.12 = 500 of 1 - aspect, and linearly
    // with it.
    const HairModel model(material(0.3f, 0.3f, 0.035f, 0.3f));
    Random random{std::mt19937(2)};
    for (int i = 0; i < 500; ++i) {
        const Vec3f wo = viewer(2.6f * random() - 1.3f),
                    wi = uniform_sphere(random.pair());
        const float h = 1.9f * random() - 0.95f, angle = 6 * random();
        const float circle = HairBsdf(model, model.sigma_a, wo, h).evaluate(wi).value.x();
        for (const float off : {1e-4f, 1e-3f}) {
            const float near = HairBsdf(model, model.sigma_a, wo, h, {1 - off, angle})
                                   .evaluate(wi)
                                   .value.x();
            EXPECT_NEAR(near, circle, (500 * off + 1e-3f) * circle + 1e-7f)
                << h << ' ' << off;
        }
    }
}

TEST(StrandSection, WhiteFurnaceScattersAllLight) {
    // Without absorption the four attenuations sum to one for any paths, up to the
    // rounding of five products. By quadrature as in HairBsdf.DensityIntegratesToOne.
    Random random{std::mt19937(3)};
    const HairModel model(material(0.3f, 0.3f, 0.05f, 0));
    for (int i = 0; i < 5000; ++i) {
        const HairBsdf bsdf(model, model.sigma_a, viewer(3 * random() - 1.5f),
                            2 * random() - 1, {0.2f + 0.8f * random(), 6 * random()});
        float sum = 0;
        for (int p = 0; p < kHairLobes; ++p) {
            sum += LobeInspection::attenuation(bsdf, p).x();
        }
        ASSERT_NEAR(sum, 1, 1e-6);
        const auto sample = draw(bsdf, random);
        ASSERT_TRUE(sample);
        ASSERT_NEAR(sample->at.value.x() / sample->at.pdf, 1, 2e-6);
    }
    Mean mean;
    for (int i = 0; i < 200000; ++i) {
        const HairBsdf bsdf(model, model.sigma_a, viewer(0.5f), 2 * random() - 1,
                            {0.5f, 6 * random()});
        mean.add(bsdf.evaluate(uniform_sphere(random.pair())).value.x() * 4 * M_PI);
    }
    EXPECT_NEAR(mean.value(), 1, kSigmas * mean.error());
}

TEST(StrandSection, SampledDirectionsFollowTheDensity) {
    // Six tests, each wrong once in 1000.
    unsigned seed = 40;
    for (const float aspect : {0.4f, 0.8f}) {
        for (const float inclination : kInclinations) {
            const HairModel model(material(0.3f, 0.3f, 0.05f, 0.2f));
            const HairBsdf bsdf(model, model.sigma_a, viewer(inclination), 0.4f,
                                {aspect, 0.6f});
            SphereBins bins(24, 48);
            Random random{std::mt19937(++seed)};
            constexpr int kCount = 50000;
            for (int i = 0; i < kCount; ++i) {
                bins.add(draw(bsdf, random).value().direction);
            }
            auto expected =
                bins.integrals([&](const Vec3f& d) { return bsdf.evaluate(d).pdf; }, 16);
            for (double& e : expected) e *= kCount;
            EXPECT_GT(pearson_chance(bins.counts, expected), 1e-3)
                << aspect << ' ' << inclination;
        }
    }
}

TEST(StrandSection, NothingIsNanAtTheEdges) {
    for (const float aspect : {0.1f, 0.5f, 0.999f}) {
        for (const float angle : {0.0f, 0.4f, kPif / 2, 3.0f}) {
            for (const float x : {-1.0f, -0.99999f, 0.0f, 1.0f}) {
                for (const float h : {-1.0f, 0.0f, 0.9999999f, 1.0f}) {
                    const HairModel model(material(0.3f, 0.3f, 0.05f, 0.5f));
                    const Vec3f wo(x, 0, std::sqrt(1 - x * x));
                    const HairBsdf bsdf(model, model.sigma_a, wo, h, {aspect, angle});
                    for (const Vec3f& wi :
                         {wo, Vec3f(-wo), Vec3f(1, 0, 0), Vec3f(0, 1, 0)}) {
                        const BsdfValue at = bsdf.evaluate(wi);
                        ASSERT_TRUE(at.value.allFinite() && std::isfinite(at.pdf))
                            << aspect << ' ' << angle << ' ' << x << ' ' << h;
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace lancret
