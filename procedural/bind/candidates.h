#pragma once
// The guides that a child may have, nearest first: those of its region, as far as
// partings and angle let it.

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "guides/base/point_tree.h"
#include "guides/helix/guides.h"
#include "procedural/bind/partings.h"
#include "procedural/bind/settings.h"

namespace lancret {

/// A search tree for the guides of each region.
class GuideIndex {
  public:
    /// `regions` has one for each root, or none: then all are in region 0.
    GuideIndex(std::span<const Vec3> roots, std::span<const std::uint32_t> regions);

    struct Group {
        std::vector<std::uint32_t> guides;  ///< of the tree's points; empty: the same
        std::vector<Vec3> roots;
        std::unique_ptr<PointTree> tree;
    };
    const Group& all() const { return all_; }
    /// The guides of `region`; null where it has none.
    const Group* of(std::uint32_t region) const;

  private:
    Group all_;
    bool one_region_;
    std::map<std::uint32_t, Group> groups_;
};

/// A child's candidates, in ascending distance.
struct Candidates {
    std::size_t size = 0;
    std::size_t within = 0;  ///< that may have a weight: those nearer than the reach, and
                             ///< where all are nearest neighbours all of these
    double reach = 0;        ///< neighbour_reach, cm
    bool from_all_regions = false;  ///< of all regions, as the child's own has none
    std::array<std::uint32_t, kMaxCandidates> guides;
    std::array<double, kMaxCandidates> distances;  ///< cm
    std::array<double, kMaxCandidates> sights;     ///< 0 to 1, past the partings
    std::array<double, kMaxCandidates> shares;     ///< sight and angle, 0 beyond a limit

    /// The nearest that is seen past the partings.
    std::optional<std::size_t> first_in_sight() const;
};

/// Finds candidates of one child after another, without asking for memory each time.
class CandidateFinder {
  public:
    CandidateFinder(const GuideIndex& index, const Guides& guides,
                    std::span<const Vec3f> normals, const BindSettings& settings,
                    const Partings* partings)
        : index_(index),
          guides_(guides),
          normals_(normals),
          settings_(settings),
          partings_(partings) {}

    /// As many of the nearest guides as it takes until their shares add up to `k` + 1, at
    /// most kMaxCandidates. Valid until the next call.
    const Candidates& find(const Vec3& place, const Vec3& up, std::uint32_t region,
                           std::size_t k);

  private:
    double set_shares(const Vec3& place, const Vec3& up);

    const GuideIndex& index_;
    const Guides& guides_;
    std::span<const Vec3f> normals_;
    const BindSettings& settings_;
    const Partings* partings_;
    Candidates out_;
    std::array<double, kMaxCandidates> squared_;
    std::vector<SeenPiece> seen_;
    std::vector<std::pair<std::uint32_t, double>> scratch_;
};

}  // namespace lancret
