#include "render_test/image/denoise.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

namespace lancret {
namespace {

constexpr int kFilterTile = 32, kGuides = 8, kPairs = kGuides * (kGuides + 1) / 2;

using Guide = Eigen::Matrix<float, kGuides, 1>;
using Slopes = Eigen::Matrix<float, kGuides, 3>;
using Moments = Eigen::Array<float, kPairs + kGuides * 3, 1>;

/// Pixels from (x0, y0) to before (x1, y1).
struct Window {
    int x0, y0, x1, y1;

    Window grown(int by, const Image& image) const {
        return {std::max(x0 - by, 0), std::max(y0 - by, 0),
                std::min(x1 + by, image.width), std::min(y1 + by, image.height)};
    }
    int across() const { return x1 - x0; }
    std::size_t size() const { return std::size_t(x1 - x0) * (y1 - y0); }
    std::size_t index(int x, int y) const {
        return std::size_t(y - y0) * across() + (x - x0);
    }
};

/// Replaces values by their sums over squares of `radius`, cut at the window's edges.
template <class T>
void box_sums(const Window& window, int radius, std::vector<T>& values) {
    std::vector<T> line(std::max(window.across(), window.y1 - window.y0));
    const auto along = [&](std::size_t first, std::size_t step, int count) {
        for (int i = 0; i < count; ++i) line[i] = values[first + i * step];
        for (int i = 0; i < count; ++i) {
            const int from = std::max(i - radius, 0),
                      to = std::min(i + radius, count - 1);
            T sum = line[from];
            for (int j = from + 1; j <= to; ++j) sum += line[j];
            values[first + i * step] = sum;
        }
    };
    for (int y = window.y0; y < window.y1; ++y) {
        along(window.index(window.x0, y), 1, window.across());
    }
    for (int x = window.x0; x < window.x1; ++x) {
        along(window.index(x, window.y0), window.across(), window.y1 - window.y0);
    }
}

/// Maps depths to 0..1, from the nearest in the image to the farthest.
struct DepthRange {
    float nearest = 0, scale = 0;
};

DepthRange depth_range(const Image& image) {
    float low = std::numeric_limits<float>::infinity(), high = 0;
    for (const float depth : image.depth) {
        if (depth > 0) low = std::min(low, depth);
        high = std::max(high, depth);
    }
    return high > low ? DepthRange{low, 1 / (high - low)} : DepthRange{};
}

Guide guide_of(const Image& image, const DepthRange& range, std::size_t i) {
    Guide guide;
    guide << 1, image.normal[i], image.tangent[i],
        (image.depth[i] - range.nearest) * range.scale;
    return image.rgba[i].w() * guide;
}

Moments moments_of(const Guide& guide, const Eigen::Vector3f& colour) {
    Moments out;
    int at = 0;
    for (int a = 0; a < kGuides; ++a) {
        for (int b = a; b < kGuides; ++b) out[at++] = guide[a] * guide[b];
    }
    for (int a = 0; a < kGuides; ++a) {
        for (int c = 0; c < 3; ++c) out[at++] = guide[a] * colour[c];
    }
    return out;
}

/// The slopes with the least squared error. That of the first guide is not regularised:
/// coverage times the error then sums to zero.
Slopes fitted(const Moments& moments, float ridge) {
    Eigen::Matrix<float, kGuides, kGuides> pairs;
    Slopes with_colour;
    int at = 0;
    for (int a = 0; a < kGuides; ++a) {
        for (int b = a; b < kGuides; ++b) pairs(a, b) = pairs(b, a) = moments[at++];
    }
    for (int a = 0; a < kGuides; ++a) {
        for (int c = 0; c < 3; ++c) with_colour(a, c) = moments[at++];
    }
    const float covered = pairs(0, 0);
    if (!(covered > 0)) return Slopes::Zero();
    for (int a = 1; a < kGuides; ++a) pairs(a, a) += ridge * covered;
    return pairs.ldlt().solve(with_colour);
}

/// Applies the guided filter to one tile.
void filter_tile(const Image& image, const DepthRange& range,
                 const DenoiseSettings& settings, const Window& tile,
                 std::vector<Vec3f>& out) {
    const Window centres = tile.grown(settings.radius, image);
    const Window all = centres.grown(settings.radius, image);
    std::vector<Moments> moments(all.size());
    for (int y = all.y0; y < all.y1; ++y) {
        for (int x = all.x0; x < all.x1; ++x) {
            const std::size_t i = std::size_t(y) * image.width + x;
            moments[all.index(x, y)] =
                moments_of(guide_of(image, range, i), image.rgba[i].head<3>());
        }
    }
    box_sums(all, settings.radius, moments);
    std::vector<Slopes> slopes(centres.size());
    for (int y = centres.y0; y < centres.y1; ++y) {
        for (int x = centres.x0; x < centres.x1; ++x) {
            slopes[centres.index(x, y)] =
                fitted(moments[all.index(x, y)], settings.ridge);
        }
    }
    box_sums(centres, settings.radius, slopes);
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const Window used = Window{x, y, x + 1, y + 1}.grown(settings.radius, image);
            const std::size_t i = std::size_t(y) * image.width + x;
            out[i] = slopes[centres.index(x, y)].transpose() * guide_of(image, range, i) /
                     float(used.size());
        }
    }
}

/// Adds detail back to one tile of `filtered`: the share of the removed signal that
/// exceeds noise.
void restore_tile(const Image& image, const std::vector<Vec3f>& filtered, int radius,
                  const Window& tile, std::vector<Vec3f>& out) {
    const Window all = tile.grown(radius, image);
    std::vector<Eigen::Array2f> powers(all.size());  // removed, noise
    for (int y = all.y0; y < all.y1; ++y) {
        for (int x = all.x0; x < all.x1; ++x) {
            const std::size_t i = std::size_t(y) * image.width + x;
            const Vec3f removed = image.rgba[i].head<3>() - filtered[i];
            powers[all.index(x, y)] = {removed.squaredNorm(),
                                       image.variance[i].head<3>().sum()};
        }
    }
    box_sums(all, radius, powers);
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const std::size_t i = std::size_t(y) * image.width + x;
            const Eigen::Array2f& power = powers[all.index(x, y)];
            const float detail = power[0] > power[1] ? 1 - power[1] / power[0] : 0;
            const Vec3f removed = image.rgba[i].head<3>() - filtered[i];
            out[i] = (filtered[i] + detail * removed).cwiseMax(0.0f);
        }
    }
}

}  // namespace

void denoise(Image& image, const DenoiseSettings& settings) {
    if (image.variance.size() != image.rgba.size()) {
        throw std::invalid_argument("denoising needs the picture's variance");
    }
    const DepthRange range = depth_range(image);
    const int across = (image.width + kFilterTile - 1) / kFilterTile;
    const int down = (image.height + kFilterTile - 1) / kFilterTile;
    const auto each_tile = [&](const auto& work) {
        tbb::parallel_for(0, across * down, [&](int tile) {
            const int x0 = tile % across * kFilterTile, y0 = tile / across * kFilterTile;
            work(Window{x0, y0, std::min(x0 + kFilterTile, image.width),
                        std::min(y0 + kFilterTile, image.height)});
        });
    };
    std::vector<Vec3f> filtered(image.rgba.size()), out(image.rgba.size());
    each_tile(
        [&](const Window& tile) { filter_tile(image, range, settings, tile, filtered); });
    each_tile([&](const Window& tile) {
        restore_tile(image, filtered, settings.shrink_radius, tile, out);
    });
    for (std::size_t i = 0; i < out.size(); ++i) image.rgba[i].head<3>() = out[i];
}

}  // namespace lancret
