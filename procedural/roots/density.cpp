#include "procedural/roots/density.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "guides/base/hash.h"

namespace lancret {

namespace {

constexpr std::uint64_t kRankSalt = 0x72616e6b;  // "rank"

/// h in density.h.
double half_fade(double density) { return std::min(kFade * density, 1 - density); }

}  // namespace

double strand_rank(std::uint64_t seed, std::uint32_t strand) {
    return unit_double(hash_bits(seed, strand, kRankSalt));
}

double width_at(double rank, double density) {
    assert(density > 0 && density <= 1);
    const double h = half_fade(density);
    if (rank < density - h) return 1 / density;
    if (rank >= density + h) return 0;
    return (density + h - rank) / (2 * h * density);
}

double lod_density(double pixels, std::size_t strands, double strands_per_pixel) {
    if (strands == 0) return 1;
    // A NaN gives density 1.
    const double density = pixels * strands_per_pixel / double(strands);
    return density < 1 ? std::max(density, kMinDensity) : 1;
}

std::vector<float> prune(std::vector<std::uint32_t>& ids, std::uint64_t seed,
                         double density) {
    std::vector<float> widths;
    std::size_t kept = 0;
    for (const std::uint32_t id : ids) {
        const double width = width_at(strand_rank(seed, id), density);
        if (!(width > 0)) continue;
        ids[kept++] = id;
        widths.push_back(float(width));
    }
    ids.resize(kept);
    return widths;
}

}  // namespace lancret
