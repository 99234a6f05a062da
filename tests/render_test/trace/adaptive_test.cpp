#include "render_test/trace/adaptive.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cstring>
#include <numeric>

#include "render_test/sampling/sampling.h"
#include "render_test/trace/render.h"
#include "tests/render_test/trace/hairy_ball.h"

namespace lancret {
namespace {

/// Pixels with `samples` samples, this mean luminance and this variance among samples.
Film film_of(int width, int height, std::uint32_t samples, float mean, float variance) {
    Film film(width, height, {.variance = true});
    std::ranges::fill(film.samples, samples);
    Eigen::Vector4f rgba = Eigen::Vector4f::Constant(mean * float(samples));
    rgba.w() = float(samples);
    std::ranges::fill(film.sums.rgba, rgba);
    std::ranges::fill(film.squares,
                      Eigen::Vector4f::Constant(variance * float(samples - 1)));
    return film;
}

TEST(Adaptive, EvenPixelsNeedTheVarianceOverTheSquareOfTheError) {
    // An error of 0.1 of the mean 2, for a variance of 3 among samples: 3 / 0.2^2 = 75.
    const Film film = film_of(9, 5, 8, 2, 3);
    for (const std::uint32_t n : samples_needed(film, 0.1f, 1000)) {
        EXPECT_GE(n, 75u);  // rounded up, by float or not
        EXPECT_LE(n, 76u);
    }
}

TEST(Adaptive, NoPixelNeedsMoreThanTheLimit) {
    for (const std::uint32_t n : samples_needed(film_of(4, 4, 8, 2, 3), 0.1f, 32)) {
        EXPECT_EQ(n, 32u);
    }
}

TEST(Adaptive, NothingIsNeededWhereNothingVariesOrAllIsBlack) {
    for (const std::uint32_t n : samples_needed(film_of(4, 4, 8, 2, 0), 0.1f, 32)) {
        EXPECT_EQ(n, 0u);
    }
    for (const std::uint32_t n : samples_needed(film_of(4, 4, 8, 0, 0), 0.1f, 32)) {
        EXPECT_EQ(n, 0u);
    }
}

TEST(Adaptive, OneBrightSampleCountsForThePixelsAroundIt) {
    Film film = film_of(20, 20, 8, 2, 0);
    film.squares[20 * 10 + 10].head<3>().setConstant(70);
    const auto needed = samples_needed(film, 0.1f, 1000);
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 20; ++x) {
            const bool near = std::abs(x - 10) <= 3 && std::abs(y - 10) <= 3;
            EXPECT_EQ(needed[std::size_t(20 * y + x)] > 0, near) << x << ' ' << y;
        }
    }
}

struct SmallBall : HairyBall {
    SmallBall() : HairyBall(64, 48, 1024) {}
    Image image(std::uint64_t* paths = nullptr) const {
        return HairyBall::image([&](const RenderProgress& p) {
            if (paths) *paths = p.paths;
        });
    }
};

/// As defined in adaptive.h: over the mean of covered pixels.
double noise(const Image& image, const Image& reference) {
    double squares = 0, sum = 0, coverage = 0;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        const double right = luminance(reference.rgba[i].head<3>());
        const double error = luminance(image.rgba[i].head<3>()) - right;
        squares += error * error, sum += right, coverage += reference.rgba[i].w();
    }
    return std::sqrt(squares / coverage) / (sum / coverage);
}

TEST(Adaptive, ThePictureReachesItsNoiseWithFewerPathsThanUniformSampling) {
    SmallBall groom;
    groom.settings.seed = 7;
    const Image reference = groom.image();
    groom.settings.seed = 0;
    std::uint64_t paths = 0;
    for (const float target : {0.2f, 0.1f}) {
        groom.settings.noise = target;
        const double reached = noise(groom.image(&paths), reference);
        // The target, plus a few hundredths for the randomness of 3,000 pixels; and not
        // twice as good as requested, which would be wasteful.
        EXPECT_LT(reached, 1.05 * target);
        EXPECT_GT(reached, 0.5 * target);
        SmallBall even;
        even.settings.samples = int(paths / (64 * 48));
        EXPECT_LT(reached, noise(even.image(), reference)) << paths / (64.0 * 48);
    }
}

TEST(Adaptive, SameBitsForAnyNumberOfThreadsAndProgressively) {
    SmallBall groom;
    groom.settings.noise = 0.3f;
    const auto same = [](const Image& a, const Image& b) {
        return std::memcmp(a.rgba.data(), b.rgba.data(),
                           a.rgba.size() * sizeof(a.rgba[0])) == 0;
    };
    const Image image = groom.image();
    {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                          1);
        EXPECT_TRUE(same(image, groom.image()));
    }
    Image last;
    render_progressively(groom.scene, groom.camera, groom.settings,
                         [&](const Image& shown, int) { last = shown; });
    EXPECT_TRUE(same(image, last));
}

TEST(Adaptive, ProgressEndsAtOneAndNeverFalls) {
    SmallBall groom;
    groom.settings.noise = 0.3f;
    double before = 0;
    render(groom.scene, groom.camera, groom.settings, [&](const RenderProgress& p) {
        EXPECT_GE(p.done, before);
        EXPECT_LE(p.done, 1);
        before = p.done;
    });
    EXPECT_EQ(before, 1);
}

}  // namespace
}  // namespace lancret
