#include "guides/mesh/scalp_roots.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "guides/base/cancel.h"
#include "guides/base/errors.h"
#include "guides/base/hash.h"

namespace lancret {

namespace {

/// g^-1 and g^-2 times 2^64, odd so that the period is 2^64.
constexpr std::array<std::uint64_t, 2> kSteps{0xc13fa9a902a6328fu, 0x91e10da5c79e7b1du};

constexpr std::size_t kChunk = 4096;       ///< candidates per task
constexpr std::size_t kChunksAtOnce = 16;  ///< per round; few, so that little is wasted
constexpr std::size_t kTrials = 1 << 17;   ///< candidates before a filter may be rejected
constexpr std::size_t kMaxTriesPerRoot = 1000;  ///< average, once those are tried

/// The lowest 21 bits of x, each followed by two zeros.
std::uint64_t spread_bits(std::uint64_t x) {
    x = (x | x << 32) & 0x001f00000000ffffu;
    x = (x | x << 16) & 0x001f0000ff0000ffu;
    x = (x | x << 8) & 0x100f00f00f00f00fu;
    x = (x | x << 4) & 0x10c30c30c30c30c3u;
    return (x | x << 2) & 0x1249249249249249u;
}

/// The triangles with an area, along a Morton curve through their centroids.
std::vector<std::uint32_t> triangles_along_curve(const Scalp& scalp) {
    const auto& mesh = scalp.mesh;
    Eigen::AlignedBox3d box;
    for (const Vec3f& p : mesh.positions) box.extend(p.cast<double>());
    const double side = box.sizes().maxCoeff();
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        if (!(scalp.areas[i] > 0)) continue;
        const Vec3 centre = scalp_position(scalp, {i, 1.0f / 3, 1.0f / 3});
        std::uint64_t key = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double t = (centre[axis] - box.min()[axis]) / side;
            key |= spread_bits(std::uint64_t(std::clamp(t, 0.0, 1.0) * 0x1fffff)) << axis;
        }
        keys.emplace_back(key, i);
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> order;
    order.reserve(keys.size());
    for (const auto& [key, triangle] : keys) order.push_back(triangle);
    return order;
}

/// Maps the unit square onto the triangle u, v >= 0, u + v <= 1, evenly and continuously:
/// each half of the square, cut along its diagonal, is sheared onto half of the triangle.
MeshPoint place_in_triangle(std::uint32_t triangle, float a, float b) {
    if (b > a) {
        a /= 2;
        b -= a;
    } else {
        b /= 2;
        a -= b;
    }
    return {triangle, a, b};
}

/// The sequence of candidates.
class Candidates {
  public:
    Candidates(const Scalp& scalp, std::uint64_t seed)
        : order_(triangles_along_curve(scalp)) {
        double sum = 0;
        for (const std::uint32_t triangle : order_) {
            area_to_.push_back(sum += scalp.areas[triangle]);
        }
        for (std::uint64_t j = 0; j < 2; ++j) start_[j] = hash_bits(seed, 0, j);
    }

    bool empty() const { return order_.empty(); }

    MeshPoint operator[](std::uint64_t n) const {
        const auto x = [&](std::size_t j) { return start_[j] + (n + 1) * kSteps[j]; };
        const double area = unit_double(x(0)) * area_to_.back();
        const auto found = std::upper_bound(area_to_.begin(), area_to_.end() - 1, area);
        const auto place = std::size_t(found - area_to_.begin());
        const double before = place > 0 ? area_to_[place - 1] : 0;
        const double rest = (area - before) / (area_to_[place] - before);
        return place_in_triangle(order_[place], std::min(float(rest), 0x1.fffffep-1f),
                                 unit_float(x(1)));
    }

  private:
    std::vector<std::uint32_t> order_;  ///< triangles
    std::vector<double> area_to_;       ///< [order_], area up to the end of each, cm^2
    std::array<std::uint64_t, 2> start_{};
};

std::vector<MeshPoint> filtered_roots(const Scalp& scalp, const Candidates& candidates,
                                      std::size_t count, const RootFilter& accept) {
    std::vector<MeshPoint> roots;
    roots.reserve(count);
    std::vector<std::vector<MeshPoint>> chunks(kChunksAtOnce);
    for (std::uint64_t next = 0; roots.size() < count; next += kChunksAtOnce * kChunk) {
        if (next >= kTrials && next / kMaxTriesPerRoot > roots.size()) {
            throw InputError(
                fmt::format("roots on the scalp: hair may grow at only {} of {} places "
                            "tried, expected at least one in {}; is the region or "
                            "density map empty?",
                            roots.size(), next, kMaxTriesPerRoot));
        }
        cancellable_for(std::size_t(0), kChunksAtOnce, [&](std::size_t c) {
            chunks[c].clear();
            for (std::uint64_t n = next + c * kChunk; n < next + (c + 1) * kChunk; ++n) {
                const MeshPoint point = candidates[n];
                if (accept(point, scalp_position(scalp, point))) {
                    chunks[c].push_back(point);
                }
            }
        });
        // In the order of the candidates, whichever thread tried them.
        for (const auto& chunk : chunks) {
            const std::size_t wanted = std::min(chunk.size(), count - roots.size());
            roots.insert(roots.end(), chunk.begin(),
                         chunk.begin() + std::ptrdiff_t(wanted));
        }
    }
    return roots;
}

}  // namespace

std::vector<MeshPoint> scalp_roots(const Scalp& scalp, std::size_t count,
                                   std::uint64_t seed, const RootFilter& accept) {
    const Candidates candidates(scalp, seed);
    if (candidates.empty()) {
        throw InputError("roots on the scalp: the scalp has no area");
    }
    if (accept) return filtered_roots(scalp, candidates, count, accept);
    std::vector<MeshPoint> roots(count);
    cancellable_for(tbb::blocked_range<std::size_t>(0, count, kChunk), [&](auto range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            roots[i] = candidates[i];
        }
    });
    return roots;
}

}  // namespace lancret
