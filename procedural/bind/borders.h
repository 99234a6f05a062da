#pragma once
// The regions and partings of a groom, on its scalp.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "guides/base/point_tree.h"
#include "guides/mesh/scalp.h"
#include "procedural/bind/partings.h"
#include "procedural/bind/region_map.h"
#include "procedural/roots/roots.h"

namespace lancret {

/// The source of a groom's regions: at most one of the two is set.
struct RegionSettings {
    std::filesystem::path texture;  ///< an image over the scalp's UVs
    std::filesystem::path ids;      ///< a text file with one region per strand

    bool any() const { return !texture.empty() || !ids.empty(); }
};

/// Roots with a search tree for the nearest.
struct RootTree {
    std::vector<Vec3> roots;
    PointTree tree{roots};

    explicit RootTree(std::span<const Vec3> points)
        : roots(points.begin(), points.end()) {}
};

/// The regions of a groom. A root's region is that of the map at the nearest point of the
/// scalp, or that of the nearest strand of the groom.
struct Regions {
    std::optional<RegionMap> map;
    std::vector<std::uint32_t> strands;      ///< [strands that grow]; empty: one region
    std::shared_ptr<const RootTree> tree{};  ///< their roots; null: built per query
};

/// Reads the regions of strands with the given `roots`; strand i is number `numbers[i]`
/// of the `in_file` strands in the groom's file. Throws InputError, which begins with
/// `name` if a map has no scalp with UVs.
Regions read_regions(const RegionSettings& settings, const std::string& name,
                     const std::optional<Scalp>& scalp, std::span<const Vec3> roots,
                     std::span<const std::uint32_t> numbers, std::size_t in_file);

/// The region of each of `places`; `roots` are the strands'. Empty if there is one
/// region only.
std::vector<std::uint32_t> regions_at(const Regions& regions,
                                      const std::optional<Scalp>& scalp,
                                      std::span<const Vec3> roots,
                                      std::span<const Vec3> places);

/// The region of each child, as regions_at, but looked up by the children's UVs.
std::vector<std::uint32_t> child_regions(const Regions& regions,
                                         std::span<const Vec3> roots,
                                         const Roots& children);

/// Appends to `chosen` (strand indices) one strand for each region that has none: the one
/// whose root is nearest to the mean of the region's roots. Returns the number added.
std::size_t choose_for_regions(const Regions& regions, std::span<const Vec3> roots,
                               std::vector<std::uint32_t>& chosen);

/// Partings, divided so that long pieces follow the scalp, with each point moved to the
/// nearest point of the scalp if there is one. `farthest` receives the largest distance
/// that a point moved, cm.
std::vector<Polyline> partings_on_scalp(std::span<const Polyline> lines,
                                        const std::optional<Scalp>& scalp,
                                        double& farthest);

}  // namespace lancret
