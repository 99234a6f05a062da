#pragma once
// The settings of binding: how many guides a child has, and which of them it may have.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "procedural/blend/blend.h"

namespace lancret {

class Partings;

/// Maximum number of guides that are considered per child, as partings and angles may
/// rule out the nearest.
inline constexpr std::size_t kMaxCandidates = 256;

struct BindSettings {
    int neighbours = 4;      ///< guides per child, 1 to kMaxNeighbours
    double exponent = 2;     ///< a of |x - x_k|^-a [TW99, Sec. 4.3], >= 0
    float length_scale = 1;  ///< a child's length over the weighted length of its guides
    bool facing = true;      ///< apply the factor (S.T_k) H(S.T_k); false if there are no
                             ///< scalp normals
    /// cm, > 0: weights fall to zero continuously at this distance.
    double max_distance = std::numeric_limits<double>::infinity();
    /// radian, > 0, between the scalp's normals at child and guide: weights fall smoothly
    /// from half of this angle to zero at all of it.
    double max_angle = std::numeric_limits<double>::infinity();
};

/// Regions and partings, which separate children from guides; none by default.
struct BindBorders {
    std::vector<std::uint32_t> guide_regions;  ///< [guides], or empty: one region
    std::vector<std::uint32_t> child_regions;  ///< [children], or empty likewise
    const Partings* partings = nullptr;        ///< not owned; null: none
};

}  // namespace lancret
