#pragma once
// What a groom says of regions and partings, brought onto its scalp.

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

/// Where a groom's regions come from: one of the two, or neither.
struct RegionSettings {
    std::filesystem::path texture;  ///< a map over the scalp's UVs
    std::filesystem::path ids;      ///< a text with the region of each strand

    bool any() const { return !texture.empty() || !ids.empty(); }
};

/// Roots that are searched for the nearest.
struct RootTree {
    std::vector<Vec3> roots;
    PointTree tree{roots};

    explicit RootTree(std::span<const Vec3> of) : roots(of.begin(), of.end()) {}
};

/// The regions of a groom. A root's region is the colour of the map where the scalp is
/// nearest to it, or that of the nearest of the groom's strands.
struct Regions {
    std::optional<RegionMap> map;
    std::vector<std::uint32_t> strands;      ///< [strands that grow]; empty: all are one
    std::shared_ptr<const RootTree> tree{};  ///< their roots; none: made when asked
};

/// Reads the regions of strands whose roots are at `roots`; strand i is number
/// `numbers[i]` of the `in_file` of the groom. Throws InputError, beginning with `name`
/// where a map has no UVs to lie on.
Regions read_regions(const RegionSettings& settings, const std::string& name,
                     const std::optional<Scalp>& scalp, std::span<const Vec3> roots,
                     std::span<const std::uint32_t> numbers, std::size_t in_file);

/// The region of each of `places`; `roots` are those of the strands.
std::vector<std::uint32_t> regions_at(const Regions& regions,
                                      const std::optional<Scalp>& scalp,
                                      std::span<const Vec3> roots,
                                      std::span<const Vec3> places);

/// The region of each child; as regions_at, but by the UVs that children have.
std::vector<std::uint32_t> child_regions(const Regions& regions,
                                         std::span<const Vec3> roots,
                                         const Roots& children);

/// Adds to `chosen`, indices of strands, one strand of each region that has none: that
/// whose root is nearest to the middle of its region. Returns how many.
std::size_t choose_for_regions(const Regions& regions, std::span<const Vec3> roots,
                               std::vector<std::uint32_t>& chosen);

/// Partings with each point put on the scalp, where there is one: divided first, so that
/// long pieces follow it. `farthest` is how far the points moved at most, cm.
std::vector<Polyline> partings_on_scalp(std::span<const Polyline> lines,
                                        const std::optional<Scalp>& scalp,
                                        double& farthest);

}  // namespace lancret
