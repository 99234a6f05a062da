#pragma once
// A groom that does not drop on frame 1.

#include <vector>

#include "guides/helix/guides.h"
#include "sim/rod/rod.h"

namespace lancret {

/// Natural curvatures with which a rod rests at `curvatures` under gravity:
/// K (q - q_n) = generalised gravity, a solution for each segment by itself.
std::vector<Vec3> sag_free_natural(const HelixState<double>& root,
                                   std::span<const double> lengths,
                                   std::span<const Vec3> curvatures,
                                   const RodSection& section, const Vec3& gravity);

/// The same for all guides, [guides * segments].
std::vector<Vec3> sag_free_natural(const Guides& guides, const RodSection& section,
                                   const Vec3& gravity);

/// The guides that rest where their energy is not at a minimum: a sag-free start is an
/// equilibrium, but one that a touch may end, and then the guide falls to another.
/// `natural` is [guides * segments]. In ascending order.
std::vector<std::size_t> falling_guides(const Guides& guides,
                                        std::span<const Vec3> natural,
                                        const RodSection& section, const Vec3& gravity);

}  // namespace lancret
