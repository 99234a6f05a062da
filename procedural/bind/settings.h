#pragma once
// What binding is asked to do: how many guides a child has, and what keeps them apart.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "procedural/blend/blend.h"

namespace lancret {

class Partings;

/// The most guides that are considered for a child: partings and angles may hide that
/// many before the search gives up.
inline constexpr std::size_t kMaxCandidates = 256;

struct BindSettings {
    int neighbours = 4;      ///< guides a child, 1 to kMaxNeighbours
    double exponent = 2;     ///< a of |x - x_k|^-a [TW99, Sec. 4.3], >= 0
    float length_scale = 1;  ///< a child's length over the weighted length of its guides
    bool facing = true;  ///< the factor (S.T_k) H(S.T_k); false where no normal is known
    /// cm, > 0: a guide as far as this has weight zero, and goes there continuously.
    double max_distance = std::numeric_limits<double>::infinity();
    /// radian, > 0, between the scalp's normals at child and guide: a guide at this angle
    /// is no candidate; from half of it on it counts less and less.
    double max_angle = std::numeric_limits<double>::infinity();
};

/// What keeps children from guides; nothing by default.
struct BindBorders {
    std::vector<std::uint32_t> guide_regions;  ///< [guides], or empty: all are one
    std::vector<std::uint32_t> child_regions;  ///< [children], or empty as well
    const Partings* partings = nullptr;        ///< that no child's guides lie across
};

}  // namespace lancret
