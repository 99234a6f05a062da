#include "render_test/light/lights.h"

#include <gtest/gtest.h>

#include <random>

#include "render_test/light/light_choice.h"
#include "render_test/sampling/sampler.h"
#include "render_test/sampling/sampling.h"
#include "tests/render_test/random.h"
#include "tests/render_test/statistics.h"

namespace lancret {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

/// A smooth map of moderate contrast.
Environment uneven_sky() {
    return Environment(sky_map(Vec3f(2, 1, 1), Vec3f(0.2f, 0.3f, 0.5f), Vec3f::Zero()),
                       Vec3f(1, 2, 3));
}

Lights with_rectangle() {
    RectangleLight light;
    light.centre = Vec3f(3, 4, 1);
    light.normal = Vec3f(-1, -2, 0.5f);
    light.up = Vec3f(0, 0, 1);
    light.size = Vec2f(5, 2);
    light.radiance = Vec3f(3, 2, 1);
    return Lights(Environment(), {}, {light});
}

Lights with_sphere(const Vec3f& centre, float radius) {
    return Lights(Environment(), {}, {}, {{centre, radius, Vec3f(3, 2, 1)}});
}

Lights mixed() {
    RectangleLight rectangle;
    rectangle.centre = Vec3f(0, 5, 0);
    rectangle.size = Vec2f(6, 3);
    rectangle.radiance = Vec3f(3, 2, 1);
    return Lights(
        uneven_sky(),
        {{Vec3f(1, 2, 0), Vec3f(2, 2, 2), 0.4f}, {Vec3f(0, -1, 1), Vec3f(1, 0, 0), 0.9f}},
        {rectangle}, {{Vec3f(-2, -1, -2), 1, Vec3f(2, 2, 2)}});
}

/// Samples each light equally often.
LightSample sample_any(const Lights& lights, const Vec3f& from, Random& random) {
    const auto light = std::size_t(random() * float(lights.size()));
    LightSample sample = lights.sample(light, from, random.pair());
    sample.pdf /= float(lights.size());
    return sample;
}

/// The sum of the densities of all lights in a direction.
float density(const Lights& lights, const Vec3f& from, const Vec3f& direction) {
    float sum = 0;
    lights.along(from, direction, kFar, [&](float pdf) {
        sum += pdf / float(lights.size());
        return 0.0f;
    });
    return sum;
}

/// The p-value of sampled directions, against densities at 24 x 24 midpoints of each bin;
/// the edge of a light adds an error of a 48th of a bin.
double sampling_chance(const Lights& lights, const Vec3f& from, unsigned seed) {
    constexpr int kCount = 40000;
    SphereBins bins(16, 32);
    Random random{std::mt19937(seed)};
    for (int i = 0; i < kCount; ++i) {
        const LightSample sample = sample_any(lights, from, random);
        if (sample.pdf > 0) bins.add(sample.direction);
    }
    auto expected =
        bins.integrals([&](const Vec3f& d) { return density(lights, from, d); }, 24);
    for (double& e : expected) e *= kCount;
    return pearson_chance(bins.counts, expected);
}

TEST(Lights, SampledDirectionsFollowTheDensity) {
    // Five tests, each wrong once in 1000.
    EXPECT_GT(sampling_chance(mixed(), Vec3f::Zero(), 1), 1e-3);
    EXPECT_GT(sampling_chance(mixed(), Vec3f(1, 1, -2), 2), 1e-3);
    EXPECT_GT(sampling_chance(with_rectangle(), Vec3f(1, 1, 1), 3), 1e-3);
    EXPECT_GT(sampling_chance(with_sphere(Vec3f(1, 2, 3), 3), Vec3f::Zero(), 4), 1e-3);
    EXPECT_GT(sampling_chance(with_sphere(Vec3f(1, 0, 0), 3), Vec3f::Zero(), 5), 1e-3);
}

TEST(Lights, SamplesCarryTheRadianceDensityAndDistanceOfTheirLight) {
    // One light at a time: the light along a sampled direction is that of the sample.
    Random random{std::mt19937(6)};
    const Vec3f from(0.5f, 0.2f, -0.3f);
    for (const Lights& lights : {with_rectangle(), with_sphere(Vec3f(1, 2, 3), 1.5f),
                                 with_sphere(Vec3f(1, 0, 0), 3)}) {
        int met = 0;
        for (int i = 0; i < 2000; ++i) {
            const LightSample s = lights.sample(1, from, random.pair());
            ASSERT_GT(s.pdf, 0);
            // Rounding of positions near 5 cm, 1e-6, over cosines and chords of at least
            // 0.1.
            const auto before = s.distance * 0.9999f, beyond = s.distance * 1.0001f;
            EXPECT_EQ(lights.along(from, s.direction, before, [](float) { return 1.0f; }),
                      Vec3f::Zero());
            const Vec3f light = lights.along(from, s.direction, beyond, [&](float pdf) {
                EXPECT_NEAR(pdf, s.pdf, 1e-3f * s.pdf);
                return 1.0f;
            });
            met += light == s.radiance;
        }
        // Samples within a rounding of the edge may miss it: about 1e-6 of them.
        EXPECT_GE(met, 1999);
    }
}

TEST(Lights, DistantLightGivesItsIrradianceToASurfaceThatFacesIt) {
    Random random{std::mt19937(8)};
    for (const float radius : {0.001f, 0.0047f, 0.5f, 1.5f}) {
        const Vec3f towards = Vec3f(1, 2, 3).normalized();
        const Lights lights(Environment(), {{towards, Vec3f(3, 2, 1), radius}});
        Mean mean;
        for (int i = 0; i < 20000; ++i) {
            const LightSample s = lights.sample(1, Vec3f::Zero(), random.pair());
            ASSERT_GT(s.pdf, 0);
            mean.add(s.radiance.x() * s.direction.dot(towards) / s.pdf);
        }
        // Float radii and solid angles are accurate to 1e-5 even for the smallest disc.
        EXPECT_NEAR(mean.value(), 3, kSigmas * mean.error() + 1e-4) << radius;
    }
}

/// Irradiance on a plane at `from` with this normal, by samples of the lights.
Mean irradiance(const Lights& lights, const Vec3f& from, const Vec3f& normal,
                unsigned seed) {
    Random random{std::mt19937(seed)};
    Mean mean;
    for (int i = 0; i < 100000; ++i) {
        const LightSample s = sample_any(lights, from, random);
        if (!(s.pdf > 0)) {
            mean.add(0);
            continue;
        }
        mean.add(s.radiance.x() * std::max(0.0f, s.direction.dot(normal)) / s.pdf);
    }
    return mean;
}

TEST(Lights, SphereGivesItsClosedFormIrradiance) {
    // A fully visible sphere: E = pi L (r / d)^2 cos. From inside, in any direction: pi
    // L.
    const Vec3f centre(0, 3, 4), normal = Vec3f::UnitY();
    const Mean outside = irradiance(with_sphere(centre, 2), Vec3f::Zero(), normal, 9);
    EXPECT_NEAR(outside.value(), M_PI * 3 * 4 / 25.0 * 3 / 5.0,
                kSigmas * outside.error());
    const Mean inside = irradiance(with_sphere(centre, 6), Vec3f::Zero(), normal, 10);
    EXPECT_NEAR(inside.value(), M_PI * 3, kSigmas * inside.error());
}

TEST(Lights, RectangleGivesItsClosedFormIrradiance) {
    // Lambert's formula for a polygon: E = L / 2 sum of angle_i * (unit normal of the
    // plane through edge i and the point) . n. The rectangle is 5 x 2 at height 3, off to
    // a side and entirely above the plane.
    RectangleLight light;
    light.centre = Vec3f(1, 3, -2);
    light.normal = -Vec3f::UnitY();
    light.up = Vec3f::UnitZ();
    light.size = Vec2f(5, 2);
    light.radiance = Vec3f::Constant(3);
    const Vec3 corners[] = {{-1.5, 3, -3}, {3.5, 3, -3}, {3.5, 3, -1}, {-1.5, 3, -1}};
    double expected = 0;
    for (int i = 0; i < 4; ++i) {
        const Vec3 a = corners[i].normalized(), b = corners[(i + 1) % 4].normalized();
        expected += std::acos(a.dot(b)) * a.cross(b).normalized().y();
    }
    expected = 3 * std::abs(expected) / 2;
    const Lights lights(Environment(), {}, {light});
    const Mean mean = irradiance(lights, Vec3f::Zero(), Vec3f::UnitY(), 11);
    EXPECT_LT(mean.error(), 0.01 * expected);
    EXPECT_NEAR(mean.value(), expected, kSigmas * mean.error());
}

TEST(Lights, RectangleIsDarkBehind) {
    const Lights lights = with_rectangle();
    const Vec3f behind = Vec3f(3, 4, 1) + Vec3f(1, 2, -0.5f);
    EXPECT_EQ(lights.sample(1, behind, {0.5f, 0.5f}).pdf, 0);
    EXPECT_EQ(lights.radiance(behind, Vec3f(-1, -2, 0.5f).normalized()), Vec3f::Zero());
}

TEST(Lights, SeveralLightsGiveTheSumOfEach) {
    // The same integral by uniform directions over all visible lights.
    const Vec3f from(1, 1, -2), normal = Vec3f(0.3f, 0.9f, 0.1f).normalized();
    const Lights lights = mixed();
    const Mean sampled = irradiance(lights, from, normal, 12);
    Random random{std::mt19937(13)};
    Mean uniform;
    for (int i = 0; i < 200000; ++i) {
        const Vec3f d = uniform_sphere(random.pair());
        uniform.add(lights.radiance(from, d).x() * std::max(0.0f, d.dot(normal)) * 4 *
                    M_PI);
    }
    EXPECT_NEAR(sampled.value(), uniform.value(),
                kSigmas * std::hypot(sampled.error(), uniform.error()));
}

TEST(Lights, TheChosenLightEstimatesTheSumOfAll) {
    const Vec3f from(1, 1, -2), normal = Vec3f(0.3f, 0.9f, 0.1f).normalized();
    const Lights lights = mixed();
    const Mean each = irradiance(lights, from, normal, 14);
    Random random{std::mt19937(15)};
    Mean chosen;
    for (int i = 0; i < 100000; ++i) {
        const float pick = random();
        chosen.add(choose_light(lights, from, pick, random.pair(),
                                [&](const LightSample& l) -> Vec3f {
                                    return l.radiance *
                                           std::max(0.0f, l.direction.dot(normal)) /
                                           l.pdf;
                                })
                       .contribution.x());
    }
    EXPECT_NEAR(chosen.value(), each.value(),
                kSigmas * std::hypot(chosen.error(), each.error()));
    EXPECT_LT(chosen.error(), each.error() / 2);
}

TEST(Lights, NoLightContributesNothing) {
    const Lights dark;
    const ChosenLight none =
        choose_light(dark, Vec3f::Zero(), 0.3f, {0.2f, 0.7f},
                     [](const LightSample& l) -> Vec3f { return l.radiance / l.pdf; });
    EXPECT_EQ(none.contribution, Vec3f::Zero());
    EXPECT_EQ(dark.radiance(Vec3f::Zero(), Vec3f::UnitX()), Vec3f::Zero());
}

TEST(Lights, RefusesInvalidLights) {
    const auto rectangle = [](auto change) {
        RectangleLight light;
        change(light);
        return Lights(Environment(), {}, {light});
    };
    EXPECT_THROW(rectangle([](auto& l) { l.size.x() = 0; }), std::invalid_argument);
    EXPECT_THROW(rectangle([](auto& l) { l.normal.setZero(); }), std::invalid_argument);
    EXPECT_THROW(rectangle([](auto& l) { l.radiance.x() = -1; }), std::invalid_argument);
    EXPECT_THROW(with_sphere(Vec3f::Zero(), 0), std::invalid_argument);
    EXPECT_THROW(with_sphere(Vec3f(NAN, 0, 0), 1), std::invalid_argument);
    EXPECT_THROW(Lights(Environment(), {{Vec3f::Zero(), Vec3f::Ones(), 0.1f}}),
                 std::invalid_argument);
}

}  // namespace
}  // namespace lancret
