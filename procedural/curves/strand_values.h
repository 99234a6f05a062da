#pragma once
// A value along strands, for rendering it as a colour.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lancret {

/// A value along every strand. Values that are not finite are stored as the largest
/// float.
struct StrandValues {
    bool at_places = false;     ///< one per place (end of an interval), else one per
                                ///< interval
    std::vector<float> values;  ///< strand after strand, root first
    std::vector<std::size_t> first{};  ///< [strands + 1], offsets into `values`; empty:
                                       ///< one value per strand

    std::size_t strands() const {
        return first.empty() ? values.size() : first.size() - 1;
    }
    std::span<const float> of(std::size_t strand) const {
        if (first.empty()) return std::span(values).subspan(strand, 1);
        return std::span(values).subspan(first[strand],
                                         first[strand + 1] - first[strand]);
    }
    /// The value at `along`, from 0 at the root to 1 at the tip: linear between places,
    /// constant in an interval.
    float at(std::uint32_t strand, float along) const;
};

}  // namespace lancret
