#pragma once
// Children grouped in chunks that are compact on the scalp.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

inline constexpr std::uint32_t kStrandsPerChunk = 4096;

/// A permutation of the children, cut into chunks.
struct Chunks {
    std::vector<std::uint32_t> children;  ///< ids, chunk after chunk, ascending in each
    std::vector<std::uint32_t> first;     ///< [size + 1], offsets into `children`

    std::size_t size() const { return first.empty() ? 0 : first.size() - 1; }
    std::span<const std::uint32_t> of(std::size_t chunk) const {
        return std::span(children).subspan(first[chunk], first[chunk + 1] - first[chunk]);
    }
    std::size_t bytes() const {
        return (children.size() + first.size()) * sizeof(std::uint32_t);
    }
};

/// Cuts `count` children into ceil(count / max_strands) chunks of nearly equal size, at
/// most `max_strands` >= 1 children each, by repeatedly halving across the longest side
/// of the box of their roots. `root` returns the root of a child, cm. The same for any
/// number of threads: children at the same place are ordered by id. Throws
/// std::invalid_argument.
Chunks make_chunks(std::size_t count, const std::function<Vec3f(std::uint32_t)>& root,
                   std::uint32_t max_strands = kStrandsPerChunk);

}  // namespace lancret
