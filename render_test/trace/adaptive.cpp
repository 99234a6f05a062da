#include "render_test/trace/adaptive.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "render_test/sampling/sampling.h"

namespace lancret {
namespace {

constexpr int kWindowReach = 3;  ///< of the window around a pixel, pixels

/// Statistics of one pixel, or their sums over several.
struct Spread {
    double luminance = 0;  ///< mean
    double variance = 0;   ///< among samples
    double coverage = 0;   ///< mean
    double pixels = 0;

    Spread& operator+=(const Spread& s) {
        luminance += s.luminance, variance += s.variance;
        coverage += s.coverage, pixels += s.pixels;
        return *this;
    }
};

Spread spread_of(const Film& film, std::size_t pixel) {
    const auto n = float(film.samples[pixel]);
    const Eigen::Vector4f& sum = film.sums.rgba[pixel];
    // Red, green and blue of a sample are correlated, so the standard deviation of their
    // weighted sum is taken as the weighted sum of theirs.
    const Vec3f deviation = (film.squares[pixel].head<3>() / (n - 1)).cwiseSqrt();
    const float total = luminance(deviation);
    return {luminance(sum.head<3>()) / n, total * total, sum.w() / n, 1};
}

}  // namespace

std::vector<std::uint32_t> samples_needed(const Film& film, float noise,
                                          std::uint32_t limit) {
    const int width = film.sums.width, height = film.sums.height;
    const auto pixel_at = [&](int x, int y) { return std::size_t(y) * width + x; };
    std::vector<Spread> rows(
        film.samples.size());  // sums over kWindowReach pixels to either side
    tbb::parallel_for(0, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            for (int i = std::max(x - kWindowReach, 0);
                 i <= std::min(x + kWindowReach, width - 1); ++i) {
                rows[pixel_at(x, y)] += spread_of(film, pixel_at(i, y));
            }
        }
    });
    Spread all;
    for (std::size_t i = 0; i < film.samples.size(); ++i) all += spread_of(film, i);
    std::vector<std::uint32_t> needed(film.samples.size());
    if (!(all.luminance > 0) || !(all.coverage > 0)) return needed;
    const double mean = all.luminance / all.coverage;
    tbb::parallel_for(0, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            Spread about;
            for (int i = std::max(y - kWindowReach, 0);
                 i <= std::min(y + kWindowReach, height - 1); ++i) {
                about += rows[pixel_at(x, i)];
            }
            if (!(about.variance > 0)) continue;
            // In almost black areas an error of a hundredth of the mean is invisible.
            const double here = std::max(about.luminance / about.pixels, 0.01 * mean);
            const double allowed = double(noise) * noise * mean * here;
            needed[pixel_at(x, y)] = std::uint32_t(std::min(
                std::ceil(about.variance / about.pixels / allowed), double(limit)));
        }
    });
    return needed;
}

}  // namespace lancret
