#pragma once
// What binding reads of guides besides themselves: made once, for any number of chunks.

#include "procedural/bind/candidates.h"

namespace lancret {

class GuideLookup {
  public:
    /// `regions` has one for each guide, or none.
    GuideLookup(const Guides& guides, std::span<const std::uint32_t> regions);

    const GuideIndex& index() const { return index_; }
    double length(std::size_t g) const { return guides_[g].length; }  ///< cm
    /// Bends hardly at all: below 1e-9 radian on every segment.
    bool straight(std::size_t g) const { return guides_[g].straight; }
    std::size_t size() const { return guides_.size(); }

  private:
    struct Guide {
        double length;
        bool straight;
    };

    GuideIndex index_;
    std::vector<Guide> guides_;
};

}  // namespace lancret
