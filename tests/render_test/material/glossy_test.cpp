#include "render_test/material/glossy.h"

#include <gtest/gtest.h>

#include <random>

#include "render_test/sampling/sampler.h"
#include "tests/render_test/random.h"
#include "tests/render_test/statistics.h"

namespace lancret {
namespace {

MeshMaterial coated(float roughness, const Vec3f& colour) {
    MeshMaterial material;
    material.colour = colour;
    material.coat_roughness = roughness;
    return material;
}

Vec3f glossy_viewer(float angle) {
    return {0.6f * std::sin(angle), 0.8f * std::sin(angle), std::cos(angle)};
}

TEST(Glossy, SampledDirectionsFollowTheDensityWithinTheUpperHalf) {
    // Directions that facets of the coat reflect downward are not sampled; they are
    // counted in a bin of their own by the density's deficit to one. Three tests, each
    // wrong once in 1000.
    unsigned seed = 1;
    for (const float roughness : {0.4f, 0.7f, 1.0f}) {
        const Glossy surface(coated(roughness, Vec3f::Constant(0.4f)), Hit(),
                             glossy_viewer(0.9f));
        Random random{std::mt19937(seed++)};
        SphereBins bins(24, 48);
        constexpr int kCount = 60000;
        double lost = 0;
        for (int i = 0; i < kCount; ++i) {
            const float pick = random();
            const auto sample = surface.sample(pick, 0, random.pair());
            if (sample) {
                bins.add(sample->direction);
            } else {
                ++lost;
            }
        }
        auto expected =
            bins.integrals([&](const Vec3f& d) { return surface.evaluate(d).pdf; }, 24);
        double left = kCount;
        for (double& e : expected) e *= kCount, left -= e;
        auto counts = bins.counts;
        counts.push_back(lost);
        expected.push_back(std::max(left, 0.0));
        EXPECT_GT(pearson_chance(counts, expected), 1e-3) << roughness;
    }
}

TEST(Glossy, IsReciprocal) {
    Random random{std::mt19937(7)};
    for (int i = 0; i < 200; ++i) {
        const Vec3f a = cosine_hemisphere(random.pair()),
                    b = cosine_hemisphere(random.pair());
        if (a.z() < 0.01f || b.z() < 0.01f) continue;
        const MeshMaterial material = coated(0.3f, Vec3f(0.2f, 0.5f, 0.9f));
        const Vec3f ab = Glossy(material, Hit(), a).evaluate(b).value / b.z();
        const Vec3f ba = Glossy(material, Hit(), b).evaluate(a).value / a.z();
        // Both are products of the same ten factors in float; the relative rounding of D
        // at alpha 0.09 is that of sin^2 / alpha^2, at worst 1e-7 / 0.008, squared.
        EXPECT_LE((ab - ba).norm(), 1e-4f * ab.norm());
    }
}

TEST(Glossy, GainsNoEnergyAndSamplingAgrees) {
    for (const float roughness : {0.1f, 0.4f, 1.0f}) {
        for (const float angle : {0.0f, 0.8f, 1.4f}) {
            const Glossy surface(coated(roughness, Vec3f::Ones()), Hit(),
                                 glossy_viewer(angle));
            Random random{std::mt19937(11)};
            Mean chosen, uniform;
            for (int i = 0; i < 60000; ++i) {
                const float pick = random();
                const auto s = surface.sample(pick, 0, random.pair());
                chosen.add(s ? s->at.value.x() / s->at.pdf : 0);
                const Vec3f wi = cosine_hemisphere(random.pair());
                if (wi.z() > 1e-4f) {
                    uniform.add(surface.evaluate(wi).value.x() * M_PI / wi.z());
                }
            }
            EXPECT_LT(chosen.value(), 1 + kSigmas * chosen.error());
            if (roughness < 0.4f) continue;  // a highlight that few cosines find
            EXPECT_NEAR(chosen.value(), uniform.value(),
                        kSigmas * std::hypot(chosen.error(), uniform.error()));
        }
    }
}

TEST(Glossy, AWhiteCoatLosesOnlyWhatFacetsAndTheCoatsInsideKeep) {
    // Straight down on a smooth coat: F = 0.04 is reflected, and of the rest the share
    // that leaves is 1 less the mean of F over cosine-weighted directions, 0.0918 for
    // index 1.5 (Walsh's closed form): 0.04 + 0.96 * 0.9082 = 0.9119.
    const Glossy surface(coated(0.1f, Vec3f::Ones()), Hit(), Vec3f::UnitZ());
    Random random{std::mt19937(12)};
    Mean mean;
    for (int i = 0; i < 100000; ++i) {
        const float pick = random();
        const auto s = surface.sample(pick, 0, random.pair());
        mean.add(s ? s->at.value.x() / s->at.pdf : 0);
    }
    // Facets of alpha 0.01 change F by its second derivative times 1e-4: negligible.
    EXPECT_NEAR(mean.value(), 0.9119, kSigmas * mean.error() + 2e-4);
}

}  // namespace
}  // namespace lancret
