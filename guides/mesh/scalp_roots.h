#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "guides/mesh/scalp.h"

namespace lancret {

/// Whether a root may stand at a point of the scalp (cm). Called from several threads,
/// also for candidates that are discarded later; must depend only on its arguments.
using RootFilter = std::function<bool(const MeshPoint&, const Vec3& position)>;

/// `count` roots spread evenly over the scalp's area: a low-discrepancy sequence, so that
/// the first n roots are even for any n, and root i does not depend on `count` (nor on
/// the number of threads). With a filter, root i is the i-th candidate that it accepts.
///
/// Candidate n is the additive recurrence x_j = seed_j + (n + 1) g^-j modulo 1, j = 1, 2,
/// with g^3 = g + 1 (Roberts' generalised golden ratio in two dimensions), in 64-bit
/// integers. x_1 chooses a triangle by area, along a Morton curve through the centroids,
/// so that near numbers give near places; the remainder of x_1 within the triangle's
/// share, and x_2, choose the place in it. The scalp is thus one unit square cut into
/// strips: on a mesh of few triangles the roots are as even as the sequence in two
/// dimensions, on one of many as even as a space-filling curve makes them. (The
/// recurrence in three dimensions, with x_1 only for the triangle, resonates with meshes
/// of 2^k triangles: up to 20 times the discrepancy at 100,000 roots.)
///
/// Throws InputError if the scalp has no area, or the filter accepts fewer than one
/// candidate in 1,000.
std::vector<MeshPoint> scalp_roots(const Scalp& scalp, std::size_t count,
                                   std::uint64_t seed, const RootFilter& accept = {});

}  // namespace lancret
