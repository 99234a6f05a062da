#include "render_test/light/environment.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "render_test/sampling/sampling.h"

namespace lancret {
namespace {

/// Writes the distribution function of weights, [size + 1]; uniform if all are zero.
/// Returns their sum.
double accumulate(std::span<const double> weights, std::span<float> distribution) {
    double total = 0;
    for (const double w : weights) total += w;
    double sum = 0;
    distribution[0] = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        sum += total > 0 ? weights[i] / total : 1.0 / double(weights.size());
        distribution[i + 1] = float(sum);
    }
    distribution[weights.size()] = 1;
    return total;
}

/// The bin that contains `random`, which is replaced by its position within the bin,
/// 0..1.
int bin_of(std::span<const float> distribution, float& random) {
    const auto above = std::upper_bound(distribution.begin(), distribution.end(), random);
    const int last = int(distribution.size()) - 2;
    const int bin = std::clamp(int(above - distribution.begin()) - 1, 0, last);
    const float width = distribution[bin + 1] - distribution[bin];
    random =
        width > 0 ? std::min((random - distribution[bin]) / width, 0x1.fffffep-1f) : 0.5f;
    return bin;
}

}  // namespace

Environment::Environment(const Vec3f& radiance)
    : Environment(Texture{1, 1, {radiance}}) {}

Environment::Environment(Texture map, const Vec3f& up, float rotation)
    : map_(std::move(map)) {
    const int w = map_.width, h = map_.height;
    if (w < 1 || h < 1 || map_.texels.size() != std::size_t(w) * h) {
        throw std::invalid_argument("an environment needs texels");
    }
    for (const Vec3f& texel : map_.texels) {
        if (!texel.allFinite() || texel.minCoeff() < 0) {
            throw std::invalid_argument("an environment must be finite and not negative");
        }
    }
    const Vec3f zenith = up.normalized();
    if (!zenith.allFinite() || !std::isfinite(rotation) || !(up.norm() > 0)) {
        throw std::invalid_argument("an environment's up axis must not be zero");
    }
    const Mat3f turn =
        Eigen::Quaternionf::FromTwoVectors(zenith, Vec3f::UnitY()).toRotationMatrix();
    to_map_ = Eigen::AngleAxisf(-rotation, Vec3f::UnitY()).toRotationMatrix() * turn;

    edges_.resize(h + 1);
    for (int y = 0; y <= h; ++y) edges_[y] = float(std::cos(M_PI * y / h));
    edges_[h] = -1;
    rows_.resize(h + 1);
    columns_.resize(std::size_t(h) * (w + 1));
    std::vector<double> across(w), down(h);
    const auto bright = [&](int x, int y) {
        return double(luminance(map_.at((x + w) % w, std::clamp(y, 0, h - 1))));
    };
    for (int y = 0; y < h; ++y) {
        // The mean of bilinear interpolation over a texel: 1/8, 6/8, 1/8 per axis.
        for (int x = 0; x < w; ++x) {
            across[x] = 0;
            for (int j = -1; j <= 1; ++j) {
                for (int i = -1; i <= 1; ++i) {
                    across[x] += bright(x + i, y + j) * (i ? 1 : 6) * (j ? 1 : 6) / 64.0;
                }
            }
        }
        const double sum = accumulate(
            across, std::span(columns_).subspan(std::size_t(y) * (w + 1), w + 1));
        const double height = double(edges_[y] - edges_[y + 1]);
        down[y] = sum * height;
    }
    accumulate(down, rows_);
}

Environment::Place Environment::place_of(const Vec3f& direction) const {
    const Vec3f d = to_map_ * direction;
    // A map of one column does not vary with azimuth.
    float turn = map_.width == 1 ? 0 : std::atan2(d.z(), d.x()) / (2 * kPif);
    if (turn < 0) turn += 1;
    const float across = std::sqrt(d.x() * d.x() + d.z() * d.z());
    const float polar = std::atan2(across, d.y()) / kPif;
    return {turn * float(map_.width), polar * float(map_.height)};
}

Vec3f Environment::radiance(const Vec3f& direction) const {
    return map_.texels.size() == 1 ? map_.texels[0] : radiance(place_of(direction));
}

float Environment::pdf(const Vec3f& direction) const {
    return map_.texels.size() == 1 ? 1 / (4 * kPif) : pdf(place_of(direction));
}

LightSample Environment::along(const Vec3f& direction) const {
    if (map_.texels.size() == 1) return {direction, map_.texels[0], 1 / (4 * kPif)};
    const Place place = place_of(direction);
    return {direction, radiance(place), pdf(place)};
}

Vec3f Environment::radiance(const Place& place) const {
    const float x = place.x - 0.5f, y = place.y - 0.5f;
    const int w = map_.width, h = map_.height;
    const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
    const float fx = x - float(x0), fy = y - float(y0);
    const int left = (x0 + w) % w, right = (x0 + 1) % w;
    const int top = std::clamp(y0, 0, h - 1), bottom = std::clamp(y0 + 1, 0, h - 1);
    return (1 - fy) * ((1 - fx) * map_.at(left, top) + fx * map_.at(right, top)) +
           fy * ((1 - fx) * map_.at(left, bottom) + fx * map_.at(right, bottom));
}

float Environment::pdf(const Place& place) const {
    return texel_pdf(std::clamp(int(place.x), 0, map_.width - 1),
                     std::clamp(int(place.y), 0, map_.height - 1));
}

float Environment::texel_pdf(int x, int y) const {
    const int w = map_.width;
    const float* column = &columns_[std::size_t(y) * (w + 1) + x];
    const float share = (rows_[y + 1] - rows_[y]) * (column[1] - column[0]);
    return share * float(w) / (2 * kPif * (edges_[y] - edges_[y + 1]));
}

LightSample Environment::sample(const Vec2f& random) const {
    const int w = map_.width;
    float u = random.x(), v = random.y();
    const int y = bin_of(rows_, v);
    const int x = bin_of(std::span(columns_).subspan(std::size_t(y) * (w + 1), w + 1), u);
    const float cosine = edges_[y] + v * (edges_[y + 1] - edges_[y]);
    const float sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
    const float phi = 2 * kPif * (float(x) + u) / float(w);
    LightSample sample;
    sample.direction =
        to_map_.transpose() * Vec3f(sine * std::cos(phi), cosine, sine * std::sin(phi));
    sample.radiance = radiance(sample.direction);
    sample.pdf = texel_pdf(x, y);
    return sample;
}

Texture sky_map(const Vec3f& zenith, const Vec3f& horizon, const Vec3f& ground) {
    Texture map{1, 64, {}};
    for (int y = 0; y < map.height; ++y) {
        const float up = std::cos(kPif * (float(y) + 0.5f) / float(map.height));
        const Vec3f& end = up > 0 ? zenith : ground;
        map.texels.push_back(horizon + std::sqrt(std::abs(up)) * (end - horizon));
    }
    return map;
}

}  // namespace lancret
