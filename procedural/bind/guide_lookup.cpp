#include "procedural/bind/guide_lookup.h"

#include <cmath>

#include "procedural/blend/guide_profiles.h"

namespace lancret {

namespace {

bool is_straight(const Guides& guides, std::size_t g) {
    const std::size_t n = std::size_t(guides.segments);
    for (std::size_t q = g * n; q < (g + 1) * n; ++q) {
        const Vec3& u = guides.curvatures[q];
        if (std::hypot(u.y(), u.z()) * guides.segment_lengths[q] > kStraightBend) {
            return false;
        }
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
