#include "procedural/bind/guide_index.h"

#include <cmath>

namespace lancret {

namespace {

bool is_straight(const Guides& guides, std::size_t g) {
    constexpr double kStraight = 1e-9;
    const std::size_t n = std::size_t(guides.segments);
    for (std::size_t q = g * n; q < (g + 1) * n; ++q) {
        const Vec3& u = guides.curvatures[q];
        if (std::hypot(u.y(), u.z()) * guides.segment_lengths[q] > kStraight)
            return false;
    }
    return true;
}

}  // namespace

GuideLookup::GuideLookup(const Guides& guides, std::span<const std::uint32_t> regions)
    : index_(guides.root_positions, regions) {
    for (std::size_t g = 0; g < guides.size(); ++g) {
        guides_.push_back({guide_length(guides, g), is_straight(guides, g)});
    }
}

}  // namespace lancret
