#pragma once
// Search trees over the guides' roots, one per region.

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "guides/base/point_tree.h"
#include "guides/base/types.h"

namespace lancret {

class GuideIndex {
  public:
    /// `regions` has one entry per root, or is empty: all roots are in one region.
    GuideIndex(std::span<const Vec3> roots, std::span<const std::uint32_t> regions);

    struct Group {
        /// The guide of each point of the tree; empty: point i is guide i.
        std::vector<std::uint32_t> guides;
        std::vector<Vec3> roots;
        std::unique_ptr<PointTree> tree;
    };
    const Group& all() const { return all_; }
    /// The guides of `region`; null if it has none.
    const Group* of(std::uint32_t region) const;

  private:
    Group all_;
    bool one_region_;
    std::map<std::uint32_t, Group> groups_;
};

}  // namespace lancret
