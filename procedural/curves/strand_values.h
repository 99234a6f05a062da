#pragma once
// A figure along strands, for pictures of it.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lancret {

/// A figure along every strand. What is not a finite number counts as the largest float.
struct StrandValues {
    bool at_places = false;            ///< at the ends of equal intervals, else in them
    std::vector<float> values;         ///< strand after strand, root first
    std::vector<std::size_t> first{};  ///< [strands + 1], into `values`; or empty: one
                                       ///< value a strand, of it as a whole

    std::size_t strands() const {
        return first.empty() ? values.size() : first.size() - 1;
    }
    std::span<const float> of(std::size_t strand) const {
        if (first.empty()) return std::span(values).subspan(strand, 1);
        return std::span(values).subspan(first[strand],
                                         first[strand + 1] - first[strand]);
    }
    /// At `along`, 0 at the root to 1 at the tip: linear between places, even within an
    /// interval.
    float at(std::uint32_t strand, float along) const;
};

}  // namespace lancret
