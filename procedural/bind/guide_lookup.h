#pragma once
// What binding reads of a groom's guides, made once and shared by all chunks.

#include "guides/helix/guides.h"
#include "procedural/bind/guide_index.h"

namespace lancret {

class GuideLookup {
  public:
    /// `regions` has one entry per guide, or is empty.
    GuideLookup(const Guides& guides, std::span<const std::uint32_t> regions);

    const GuideIndex& index() const { return index_; }
    double length(std::size_t g) const { return guides_[g].length; }  ///< cm
    /// Whether every segment bends by less than kStraightBend.
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
