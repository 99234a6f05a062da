#include "procedural/bind/borders.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "guides/base/cancel.h"
#include "guides/base/errors.h"
#include "guides/base/point_tree.h"
#include "guides/mesh/closest_point.h"

namespace lancret {

namespace {

std::vector<std::uint32_t> map_regions(const RegionMap& map, const Scalp& scalp,
                                       std::span<const Vec3> places) {
    std::vector<std::uint32_t> out(places.size());
    const ClosestPoint closest(scalp.mesh);
    for (std::size_t i = 0; i < places.size(); ++i) {
        out[i] = region_at(map, scalp_uv(scalp, closest.closest(places[i]).point));
    }
    return out;
}

/// The region of the strand nearest to place_of(i), i = 0 .. count - 1.
template <class PlaceOf>
std::vector<std::uint32_t> nearest_regions(const Regions& regions,
                                           std::span<const Vec3> roots, std::size_t count,
                                           PlaceOf place_of) {
    std::vector<std::uint32_t> out(count);
    const auto strands =
        regions.tree ? regions.tree : std::make_shared<const RootTree>(roots);
    cancellable_for(std::size_t(0), count, [&](std::size_t i) {
        std::uint32_t nearest = 0;
        double squared = 0;
        strands->tree.nearest(place_of(i), {&nearest, 1}, {&squared, 1});
        out[i] = regions.strands[nearest];
    });
    return out;
}

}  // namespace

Regions read_regions(const RegionSettings& settings, const std::string& name,
                     const std::optional<Scalp>& scalp, std::span<const Vec3> roots,
                     std::span<const std::uint32_t> numbers, std::size_t in_file) {
    Regions out;
    if (!settings.ids.empty()) {
        const auto ids = read_region_ids(settings.ids, in_file);
        for (const std::uint32_t i : numbers) out.strands.push_back(ids[i]);
        out.tree = std::make_shared<RootTree>(roots);
    } else if (!settings.texture.empty()) {
        if (!scalp || scalp->mesh.uvs.empty()) {
            throw InputError(
                fmt::format("{}: the texture of [regions] needs a scalp with UVs, but {}",
                            name, scalp ? "the scalp has none" : "there is no scalp"));
        }
        out.map = read_region_map(settings.texture);
        out.strands = map_regions(*out.map, *scalp, roots);
    }
    return out;
}

std::vector<std::uint32_t> regions_at(const Regions& regions,
                                      const std::optional<Scalp>& scalp,
                                      std::span<const Vec3> roots,
                                      std::span<const Vec3> places) {
    if (regions.map) return map_regions(*regions.map, *scalp, places);
    if (regions.strands.empty()) return {};
    return nearest_regions(regions, roots, places.size(),
                           [&](std::size_t i) { return places[i]; });
}

std::vector<std::uint32_t> child_regions(const Regions& regions,
                                         std::span<const Vec3> roots,
                                         const Roots& children) {
    if (regions.map) {
        std::vector<std::uint32_t> out(children.size());
        for (std::size_t i = 0; i < out.size(); ++i) {
            out[i] = region_at(*regions.map, children.uvs[i].cast<double>());
        }
        return out;
    }
    if (regions.strands.empty()) return {};
    return nearest_regions(regions, roots, children.size(), [&](std::size_t i) -> Vec3 {
        return children.positions[i].cast<double>();
    });
}

std::size_t choose_for_regions(const Regions& regions, std::span<const Vec3> roots,
                               std::vector<std::uint32_t>& chosen) {
    if (regions.strands.empty()) return 0;
    std::set<std::uint32_t> served;
    for (const std::uint32_t i : chosen) served.insert(regions.strands[i]);
    std::map<std::uint32_t, std::vector<std::uint32_t>> without;
    for (std::uint32_t i = 0; i < regions.strands.size(); ++i) {
        if (!served.contains(regions.strands[i])) {
            without[regions.strands[i]].push_back(i);
        }
    }
    for (const auto& [region, strands] : without) {
        Vec3 middle = Vec3::Zero();
        for (const std::uint32_t i : strands) middle += roots[i] / double(strands.size());
        chosen.push_back(*std::ranges::min_element(strands, {}, [&](std::uint32_t i) {
            return (roots[i] - middle).squaredNorm();
        }));
    }
    return without.size();
}

std::vector<Polyline> partings_on_scalp(std::span<const Polyline> lines,
                                        const std::optional<Scalp>& scalp,
                                        double& farthest) {
    farthest = 0;
    std::vector<Polyline> out = divided(lines);
    if (!scalp || out.empty()) return out;
    const ClosestPoint closest(scalp->mesh);
    for (Polyline& line : out) {
        for (Vec3& p : line) {
            const ClosestResult nearest = closest.closest(p);
            farthest = std::max(farthest, nearest.distance);
            p = nearest.position;
        }
    }
    return out;
}

}  // namespace lancret
