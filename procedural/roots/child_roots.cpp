#include "procedural/roots/child_roots.h"

#include <fmt/format.h>
#include <oneapi/tbb/blocked_range.h>

#include <algorithm>
#include <numeric>

#include "guides/base/cancel.h"
#include "guides/base/errors.h"
#include "guides/base/farthest_points.h"
#include "guides/base/hash.h"
#include "guides/base/point_tree.h"
#include "guides/mesh/scalp_roots.h"

namespace lancret {

namespace {

constexpr std::uint64_t kStrandRootSalt = 0x726f6f74;  // "root"
constexpr std::size_t kNormalNeighbours = 8;

/// The roots at places on a scalp.
Roots scalp_roots_at(const Scalp& scalp, std::vector<MeshPoint> places) {
    Roots out;
    out.places = std::move(places);
    const std::size_t count = out.places.size();
    out.positions.resize(count);
    out.normals.resize(count);
    out.uvs.resize(count);
    cancellable_for(
        tbb::blocked_range<std::size_t>(0, count, 1024), [&](const auto& range) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                out.positions[i] = scalp_position(scalp, out.places[i]).cast<float>();
                out.normals[i] = scalp_normal(scalp, out.places[i]).cast<float>();
                out.uvs[i] = scalp_uv(scalp, out.places[i]).cast<float>();
            }
        });
    return out;
}

}  // namespace

double growth_of_spacing(std::span<const Vec3> grown) {
    std::vector<double> spacing = neighbour_distances(grown);
    const std::size_t nth = spacing.size() * 9 / 10;
    std::ranges::nth_element(spacing, spacing.begin() + std::ptrdiff_t(nth));
    return 1.5 * spacing[nth];
}

std::vector<MeshPoint> places_on_scalp(const Scalp& scalp, std::span<const Vec3> grown,
                                       std::uint32_t count, std::uint64_t seed,
                                       double growth) {
    const PointTree tree(grown);
    RootFilter near;
    if (std::isfinite(growth)) {
        near = [&](const MeshPoint&, const Vec3& position) {
            return tree.nearest_squared(position) <= growth * growth;
        };
    }
    return scalp_roots(scalp, count, seed, near);
}

Roots roots_at(const Scalp* scalp, RootPlaces places) {
    return scalp ? scalp_roots_at(*scalp, std::move(places.on_scalp))
                 : std::move(places.on_strands);
}

Roots roots_at(const Scalp* scalp, const RootPlaces& places,
               std::span<const std::uint32_t> which) {
    Roots out;
    if (scalp) {
        std::vector<MeshPoint> chosen;
        chosen.reserve(which.size());
        for (const std::uint32_t i : which) chosen.push_back(places.on_scalp[i]);
        out = scalp_roots_at(*scalp, std::move(chosen));
    } else {
        out = picked(places.on_strands, which);
    }
    out.ids.assign(which.begin(), which.end());
    return out;
}

Roots roots_of_strands(std::span<const Vec3> grown, std::span<const Vec3> tangents,
                       std::uint32_t count, std::uint64_t seed, const std::string& name) {
    if (count > grown.size()) {
        throw InputError(
            fmt::format("{}: {} children need a scalp, as the groom has only {} roots of "
                        "its own: name a mesh with --scalp, or request fewer --strands",
                        name, count, grown.size()));
    }
    std::vector<std::uint32_t> order(grown.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto rank = [&](std::uint32_t i) {
        return hash_bits(seed, i, kStrandRootSalt);
    };
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(rank(a), a) < std::pair(rank(b), b);
    });
    order.resize(count);
    const PointTree tree(grown);
    Roots out;
    out.positions.resize(count);
    out.normals.resize(count);
    cancellable_for(std::uint32_t(0), count, [&](std::uint32_t i) {
        const Vec3& place = grown[order[i]];
        std::array<std::uint32_t, kNormalNeighbours> near;
        std::array<double, kNormalNeighbours> squared;
        const std::size_t found = tree.nearest(place, near, squared);
        Vec3 mean = Vec3::Zero();
        for (std::size_t k = 0; k < found; ++k) mean += tangents[near[k]];
        const Vec3 normal = mean.norm() > 1e-6 ? mean.normalized() : tangents[order[i]];
        out.positions[i] = place.cast<float>();
        out.normals[i] = normal.cast<float>();
    });
    return out;
}

}  // namespace lancret
