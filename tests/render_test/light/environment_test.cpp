#include "render_test/light/environment.h"

#include <gtest/gtest.h>

#include <random>

#include "render_test/sampling/sampler.h"
#include "render_test/sampling/sampling.h"
#include "tests/render_test/statistics.h"

namespace lancret {
namespace {

/// 16 x 8 texels, one of them bright, some black.
Texture uneven_map() {
    Texture map{16, 8, {}};
    std::mt19937 random(1);
    for (int i = 0; i < 128; ++i) {
        const float x = unit_float(random());
        map.texels.push_back(Vec3f(x, x * x, 0.3f) * (i % 5 ? 1.0f : 0.0f));
    }
    map.texels[37] = Vec3f(60, 50, 40);
    return map;
}

double sampling_chance(const Environment& light, int count, unsigned seed) {
    // Bins about x, as fine as 5 degrees. The density is constant within texels, whose
    // edges cross bins: 24 x 24 midpoints locate an edge to 1/48 of a bin.
    SphereBins bins(16, 32);
    std::mt19937 random(seed);
    for (int i = 0; i < count; ++i) {
        const float u = unit_float(random());
        bins.add(light.sample({u, unit_float(random())}).direction);
    }
    auto expected = bins.integrals([&](const Vec3f& d) { return light.pdf(d); }, 24);
    for (double& e : expected) e *= count;
    return pearson_chance(bins.counts, expected);
}

TEST(Environment, SampledDirectionsFollowTheDensity) {
    // Three tests, each wrong once in 1000.
    EXPECT_GT(sampling_chance(Environment(uneven_map()), 40000, 1), 1e-3);
    EXPECT_GT(sampling_chance(Environment(uneven_map(), Vec3f(1, 2, 3), 0.7f), 40000, 2),
              1e-3);
    EXPECT_GT(sampling_chance(Environment(Vec3f::Ones()), 40000, 3), 1e-3);
}

TEST(Environment, SamplesCarryTheRadianceAndDensityOfTheirDirection) {
    const Environment environment(uneven_map(), Vec3f(0, 0, 1), 1.0f);
    std::mt19937 random(4);
    int same = 0;
    for (int i = 0; i < 2000; ++i) {
        const float u = unit_float(random());
        const LightSample s = environment.sample({u, unit_float(random())});
        EXPECT_EQ(s.radiance, environment.radiance(s.direction));
        same += std::abs(s.pdf - environment.pdf(s.direction)) <= 1e-5f * s.pdf;
    }
    // Rounding moves a direction across a texel's edge in about 1e-6 / (2 pi / 16) of
    // cases.
    EXPECT_GE(same, 1999);
}

TEST(Environment, SampledIntegralIsTheUniformOne) {
    const Environment environment(uneven_map());
    std::mt19937 random(5);
    Mean chosen, uniform;
    for (int i = 0; i < 100000; ++i) {
        const float u = unit_float(random());
        const Vec2f pair(u, unit_float(random()));
        const LightSample s = environment.sample(pair);
        chosen.add(luminance(s.radiance) / s.pdf);
        uniform.add(luminance(environment.radiance(uniform_sphere(pair))) * 4 * M_PI);
    }
    EXPECT_NEAR(chosen.value(), uniform.value(),
                kSigmas * std::hypot(chosen.error(), uniform.error()));
    EXPECT_LT(chosen.error(), uniform.error() / 4);
}

TEST(Environment, AlongIsRadianceAndDensity) {
    const Environment environments[] = {Environment(uneven_map()),
                                        Environment(Vec3f(1, 2, 3))};
    for (const Environment& environment : environments) {
        for (std::uint32_t i = 0; i < 100; ++i) {
            const Vec3f d = uniform_sphere(Sampler(5, i, 0).next());
            const LightSample along = environment.along(d);
            EXPECT_EQ(along.direction, d);
            EXPECT_EQ(along.radiance, environment.radiance(d));
            EXPECT_EQ(along.pdf, environment.pdf(d));
        }
    }
}

TEST(Environment, UpAxisIsTheMapsTop) {
    Texture map{1, 2, {Vec3f(1, 0, 0), Vec3f(0, 1, 0)}};
    for (const Vec3f& up : {Vec3f(0, 1, 0), Vec3f(0, 0, 1), Vec3f(0, -1, 0)}) {
        const Environment environment(map, up);
        EXPECT_LT((environment.radiance(up) - Vec3f(1, 0, 0)).norm(), 1e-5f);
        EXPECT_LT((environment.radiance(-up) - Vec3f(0, 1, 0)).norm(), 1e-5f);
    }
}

TEST(Environment, RotationTurnsTheMapAboutTheUpAxis) {
    const Texture map = uneven_map();
    const Environment still(map), turned(map, Vec3f::UnitY(), 0.9f);
    const Eigen::AngleAxisf turn(0.9f, Vec3f::UnitY());
    std::mt19937 random(6);
    for (int i = 0; i < 100; ++i) {
        const float u = unit_float(random());
        const Vec3f d = uniform_sphere({u, unit_float(random())});
        // The largest step between texels, 60 over 22 degrees, times 1e-6 radian.
        EXPECT_LT((turned.radiance(turn * d) - still.radiance(d)).norm(), 1e-3f);
    }
}

TEST(Environment, RefusesInvalidRadiance) {
    EXPECT_THROW(Environment(Texture{}), std::invalid_argument);
    EXPECT_THROW(Environment(Vec3f(1, -1, 1)), std::invalid_argument);
    EXPECT_THROW(Environment(Vec3f(1, NAN, 1)), std::invalid_argument);
    EXPECT_THROW(Environment(uneven_map(), Vec3f::Zero()), std::invalid_argument);
}

}  // namespace
}  // namespace lancret
