#pragma once
// Level of detail: some of the strands, wider, in the place of all [Cook, Halstead,
// Planck, Ryu 2007, Stochastic Simplification of Aggregate Detail].
//
// Each strand has a rank, drawn by hash, and is kept while its rank is below the density
// d: a smaller set is a subset of a larger one. What is kept is 1 / d as wide, so that
// the area of all strands together, width times length, is kept in the mean. So that no
// strand comes or goes at once, widths fall to nothing over ranks about d:
//
//     w(r, d) = clamp((d + h - r) / 2h, 0, 1) / d,   h = min(kFade d, 1 - d),
//
// whose integral over r in [0, 1] is 1. It is continuous in d, and 1 for all at d = 1.

#include <cstdint>
#include <span>

#include "procedural/roots/roots.h"

namespace lancret {

inline constexpr double kMinDensity = 1e-6;
/// Half the share of ranks about the density at which strands fade.
inline constexpr double kFade = 0.1;

/// In [0, 1): the strand's place in the order in which strands are kept.
double strand_rank(std::uint64_t seed, std::uint32_t strand);

/// A strand's width over its own; 0 where it is not grown. `density` is in (0, 1].
double width_at(double rank, double density);

/// What the summed width of `strands` strands of one length is off by from their own, as
/// a standard deviation, relative: sqrt((integral of w^2 - 1) / strands).
double area_deviation(double density, std::size_t strands);

/// The share of strands at which a projection of `pixels` pixels shows
/// `strands_per_pixel` of them: all where there are not that many.
double lod_density(double pixels, std::size_t strands, double strands_per_pixel);

/// Drops from `ids` what is not grown at `density`, and gives the widths of the rest.
std::vector<float> prune(std::vector<std::uint32_t>& ids, std::uint64_t seed,
                         double density);

}  // namespace lancret
