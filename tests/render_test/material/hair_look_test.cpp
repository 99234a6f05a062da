#include "render_test/material/hair_look.h"

#include <gtest/gtest.h>

#include "tests/render_test/statistics.h"

namespace lancret {
namespace {

TEST(HairLook, WithoutVariationEveryStrandIsTheMaterial) {
    const HairMaterial material;
    const HairLook look(material);
    const HairModel model(material);
    for (const std::uint32_t strand : {0u, 1u, 77u}) {
        EXPECT_EQ(look.sigma_a(strand, 0.3f), model.sigma_a);
        EXPECT_EQ(look.model(strand).variance[0], model.variance[0]);
    }
}

TEST(HairLook, MelaninVariesEvenlyAboutTheMaterials) {
    HairMaterial material;
    material.melanin_variation = 0.4f;
    const HairLook look(material);
    const float middle = sigma_a_of(material).y();
    Mean mean, squares;
    for (std::uint32_t strand = 0; strand < 20000; ++strand) {
        const float share = look.sigma_a(strand, 0).y() / middle;
        ASSERT_GE(share, 0.6f - 1e-5f);
        ASSERT_LE(share, 1.4f + 1e-5f);
        mean.add(share);
        squares.add((share - 1) * (share - 1));
    }
    // Uniform on 1 -+ 0.4: variance 0.4^2 / 3.
    EXPECT_NEAR(mean.value(), 1, kSigmas * mean.error());
    EXPECT_NEAR(squares.value(), 0.16 / 3, kSigmas * squares.error());
}

TEST(HairLook, RoughnessVariesWithinItsShareAndApartFromMelanin) {
    HairMaterial material;
    material.roughness_variation = material.melanin_variation = 0.5f;
    const HairLook look(material);
    HairMaterial low = material, high = material;
    low.beta_m *= 0.5f, high.beta_m *= 1.5f;
    const float least = HairModel(low).variance[0], most = HairModel(high).variance[0];
    float smallest = most, largest = least;
    Mean together, v, m;
    for (std::uint32_t strand = 0; strand < 20000; ++strand) {
        const float variance = look.model(strand).variance[0];
        ASSERT_GE(variance, least);
        ASSERT_LE(variance, most);
        smallest = std::min(smallest, variance);
        largest = std::max(largest, variance);
        const float sigma = look.sigma_a(strand, 0).x();
        v.add(variance), m.add(sigma), together.add(double(variance) * sigma);
    }
    EXPECT_EQ(smallest, least);
    EXPECT_EQ(largest, most);
    // Independent: the mean of the product is the product of the means.
    EXPECT_NEAR(together.value(), v.value() * m.value(), kSigmas * together.error());
}

TEST(HairLook, EndsShowTheirColoursAndAbsorptionIsLinearBetween) {
    HairMaterial material;
    material.root_colour = Vec3f(0.2f, 0.1f, 0.05f);
    material.tip_colour = Vec3f(0.8f, 0.7f, 0.5f);
    const HairLook look(material);
    // The exponent of the fit, up to 6 sqrt(sigma) = 3, in float: 1e-6 of the value.
    EXPECT_LT((look.colour(5, 0) - *material.root_colour).norm(), 1e-6f);
    EXPECT_LT((look.colour(5, 1) - *material.tip_colour).norm(), 2e-6f);
    EXPECT_LT(
        (look.sigma_a(5, 0.25f) - 0.75f * look.sigma_a(5, 0) - 0.25f * look.sigma_a(5, 1))
            .norm(),
        1e-7f);
    material.tip_colour.reset();
    // Two roundings of numbers below 2.
    EXPECT_LT((HairLook(material).sigma_a(5, 1) - sigma_a_of(material)).norm(), 5e-7f);
}

TEST(HairLook, MinimumRoughnessAffectsSmootherStrandsAndKeepsTheirAbsorption) {
    HairMaterial material;
    material.root_colour = Vec3f(0.2f, 0.1f, 0.05f);
    material.roughness_variation = material.melanin_variation = 0.5f;
    const float least = 0.35f;
    const HairLook look(material), wide(material, least);
    HairMaterial round = material;
    round.beta_m = round.beta_n = least;
    const HairModel floor(round);
    int widened = 0;
    for (std::uint32_t strand = 0; strand < 1000; ++strand) {
        const HairModel &plain = look.model(strand), &model = wide.model(strand);
        // v and s grow with the roughness.
        EXPECT_EQ(model.variance[0], std::max(plain.variance[0], floor.variance[0]));
        EXPECT_EQ(model.s, std::max(plain.s, floor.s));
        widened += model.s > plain.s;
        // Also for the root colour, although the absorption of a colour depends on
        // beta_n.
        EXPECT_EQ(wide.sigma_a(strand, 0.3f), look.sigma_a(strand, 0.3f));
    }
    // Of 17 roughnesses from 0.15 to 0.45 the lower 11 are below the minimum, the first
    // half as often: 10.5 / 16 of 1000 strands, -+ 15 by the binomial.
    EXPECT_NEAR(widened, 656, kSigmas * 15);
    EXPECT_THROW(HairLook(material, 1.5f), std::invalid_argument);
}

TEST(HairLook, ASeedGivesOtherStrandsAndTheSameSeedTheSame) {
    HairMaterial material;
    material.melanin_variation = 1;
    const HairLook look(material), again(material);
    material.seed = 1;
    const HairLook other(material);
    EXPECT_EQ(look.sigma_a(3, 0), again.sigma_a(3, 0));
    EXPECT_NE(look.sigma_a(3, 0), other.sigma_a(3, 0));
}

TEST(HairLook, RefusesWhatIsOutOfRange) {
    HairMaterial material;
    material.melanin_variation = 1.5f;
    EXPECT_THROW(HairLook{material}, std::invalid_argument);
    material = {};
    material.tip_colour = Vec3f(0, 0, 2);
    EXPECT_THROW(HairLook{material}, std::invalid_argument);
    material = {};
    material.roughness_variation = 0.5f;
    material.beta_m = 2;
    EXPECT_THROW(HairLook{material}, std::invalid_argument);
}

}  // namespace
}  // namespace lancret
