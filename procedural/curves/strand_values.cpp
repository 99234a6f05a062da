#include "procedural/curves/strand_values.h"

#include <algorithm>

namespace lancret {

float StrandValues::at(std::uint32_t strand, float along) const {
    const std::span<const float> samples = of(strand);
    if (samples.size() == 1) return samples[0];
    const std::size_t intervals = at_places ? samples.size() - 1 : samples.size();
    const float place = std::clamp(along, 0.0f, 1.0f) * float(intervals);
    const std::size_t j = std::min(std::size_t(place), intervals - 1);
    if (!at_places) return samples[j];
    const float share = place - float(j);
    return (1 - share) * samples[j] + share * samples[j + 1];
}

}  // namespace lancret
