#include "procedural/bind/guide_index.h"

namespace lancret {

GuideIndex::GuideIndex(std::span<const Vec3> roots,
                       std::span<const std::uint32_t> regions)
    : one_region_(regions.empty()) {
    all_.tree = std::make_unique<PointTree>(roots);
    for (std::size_t g = 0; g < regions.size(); ++g) {
        Group& group = groups_[regions[g]];
        group.guides.push_back(std::uint32_t(g));
        group.roots.push_back(roots[g]);
    }
    for (auto& [region, group] : groups_) {
        group.tree = std::make_unique<PointTree>(group.roots);
    }
}

const GuideIndex::Group* GuideIndex::of(std::uint32_t region) const {
    if (one_region_) return &all_;
    const auto found = groups_.find(region);
    return found == groups_.end() ? nullptr : &found->second;
}

}  // namespace lancret
