#pragma once
// Level of detail: a subset of the strands, drawn wider, in place of all [Cook, Halstead,
// Planck, Ryu 2007, Stochastic Simplification of Aggregate Detail].
//
// Each strand has a rank, drawn by a hash, and is kept while its rank is below the
// density d, so that a smaller set is a subset of a larger one. Kept strands are 1 / d as
// wide, which preserves the expected area (width times length) of all strands together.
// Widths fall to zero over a range of ranks about d, so that no strand appears or
// vanishes at once:
//
//     w(r, d) = clamp((d + h - r) / 2h, 0, 1) / d,   h = min(kFade d, 1 - d),
//
// whose integral over r in [0, 1] is 1. It is continuous in d, and 1 for all r at d = 1.

#include <cstdint>
#include <span>
#include <vector>

namespace lancret {

inline constexpr double kMinDensity = 1e-6;
/// Half the width of the fade over ranks, as a fraction of the density.
inline constexpr double kFade = 0.1;

/// Position of a strand in the order in which strands are kept, in [0, 1).
double strand_rank(std::uint64_t seed, std::uint32_t strand);

/// Width of a strand relative to its width at density 1; 0 if it is not grown. `density`
/// is in (0, 1].
double width_at(double rank, double density);

/// The density at which `strands_per_pixel` strands fall on each of `pixels` pixels, at
/// least kMinDensity; 1 if there are fewer than that.
double lod_density(double pixels, std::size_t strands, double strands_per_pixel);

/// Removes from `ids` the strands that are not grown at `density`; returns the relative
/// widths of the rest.
std::vector<float> prune(std::vector<std::uint32_t>& ids, std::uint64_t seed,
                         double density);

}  // namespace lancret
