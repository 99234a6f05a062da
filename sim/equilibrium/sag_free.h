#pragma once
// Natural curvatures that keep a groom from dropping on frame 1.

#include <vector>

#include "guides/helix/guides.h"
#include "sim/rod/rod.h"

namespace lancret {

/// Natural curvatures with which a rod rests at `curvatures` under gravity:
/// K (q - q_n) = generalised gravity, solved per segment.
std::vector<Vec3> sag_free_natural(const HelixState<double>& root,
                                   std::span<const double> lengths,
                                   std::span<const Vec3> curvatures,
                                   const RodSection& section, const Vec3& gravity);

/// The same for all guides; returns [guides * segments].
std::vector<Vec3> sag_free_natural(const Guides& guides, const RodSection& section,
                                   const Vec3& gravity);

/// Indices, ascending, of the guides whose sag-free rest shape is an unstable
/// equilibrium: its energy is not at a minimum, so the guide falls to another equilibrium
/// at the slightest disturbance. `natural` is [guides * segments].
std::vector<std::size_t> falling_guides(const Guides& guides,
                                        std::span<const Vec3> natural,
                                        const RodSection& section, const Vec3& gravity);

}  // namespace lancret
