#include "render_test/image/colour_scale.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lancret {
namespace {

/// OKLab's lightness of a linear colour, by the inverse formula.
float lightness(const Vec3f& c) {
    const float l = 0.4122214708f * c.x() + 0.5363325363f * c.y() + 0.0514459929f * c.z();
    const float m = 0.2119034982f * c.x() + 0.6806995451f * c.y() + 0.1073969566f * c.z();
    const float s = 0.0883024619f * c.x() + 0.2817188376f * c.y() + 0.6299787005f * c.z();
    return 0.2104542553f * std::cbrt(l) + 0.7936177850f * std::cbrt(m) -
           0.0040720468f * std::cbrt(s);
}

// Matrices of ten digits in single precision: 1e-5. A colour outside the gamut would be
// clamped, and its lightness differ by far more.
constexpr float kTolerance = 1e-5f;

TEST(ColourScale, LightnessIsInProportionToTheValue) {
    for (int i = 0; i <= 100; ++i) {
        const float t = float(i) / 100;
        EXPECT_NEAR(lightness(sequential_colour(t)), 0.38f + 0.54f * t, kTolerance) << t;
    }
}

TEST(ColourScale, BothSidesOfZeroAreAsDark) {
    for (int i = 0; i <= 100; ++i) {
        const float t = float(i) / 100;
        EXPECT_NEAR(lightness(diverging_colour(t)), 0.88f - 0.33f * t, kTolerance) << t;
        EXPECT_NEAR(lightness(diverging_colour(-t)), 0.88f - 0.33f * t, kTolerance) << t;
    }
    const Vec3f middle = diverging_colour(0);
    EXPECT_NEAR(middle.x(), middle.y(), 1e-5);
    EXPECT_NEAR(middle.z(), middle.y(), 1e-5);
    EXPECT_GT(diverging_colour(1).x(), 3 * diverging_colour(1).z());
    EXPECT_GT(diverging_colour(-1).z(), 3 * diverging_colour(-1).x());
}

TEST(ColourScale, ValuesBeyondTheEndsAreClamped) {
    EXPECT_EQ(sequential_colour(-3), sequential_colour(0));
    EXPECT_EQ(sequential_colour(1e30f), sequential_colour(1));
    EXPECT_EQ(diverging_colour(-7), diverging_colour(-1));
}

TEST(ColourScale, CategoriesNearInNumberAreFarInColour) {
    for (std::uint32_t a = 0; a < 60; ++a) {
        // None of the three lightnesses is clamped at the gamut's edge.
        EXPECT_NEAR(lightness(category_colour(a)),
                    a % 3 == 0   ? 0.7f
                    : a % 3 == 1 ? 0.58f
                                 : 0.8f,
                    kTolerance);
        for (std::uint32_t b = a + 1; b < a + 6; ++b) {
            EXPECT_GT((category_colour(a) - category_colour(b)).norm(), 0.1f)
                << a << ' ' << b;
        }
    }
}

TEST(ColourScale, NoColourOfAScaleIsTakenForAFailure) {
    for (int i = 0; i <= 100; ++i) {
        EXPECT_GT((sequential_colour(float(i) / 100) - kFailColour).norm(), 0.3f) << i;
    }
}

}  // namespace
}  // namespace lancret
