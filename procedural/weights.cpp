#include "procedural/weights.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lancret {

bool guide_weights(std::span<const double> distances, double reach,
                   std::span<const double> facing, double exponent,
                   std::span<float> weights) {
    std::ranges::fill(weights, 0.0f);
    if (distances[0] <= 1e-7) {
        weights[0] = 1;
        return true;
    }
    // Relative to the nearest, so that no power of a small distance overflows. Where all
    // are as far as the reach, they differ by their facing alone.
    const bool even = distances[0] >= reach * (1 - 1e-9);
    double sum = 0;
    std::array<double, 64> raw;
    for (std::size_t k = 0; k < weights.size(); ++k) {
        const double near = even ? 1 : distances[0] / distances[k] - distances[0] / reach;
        raw[k] = near > 0 ? std::pow(near, exponent) * std::max(0.0, facing[k]) : 0;
        sum += raw[k];
    }
    if (!(sum > 0)) {
        weights[0] = 1;
        return false;
    }
    for (std::size_t k = 0; k < weights.size(); ++k) weights[k] = float(raw[k] / sum);
    return true;
}

}  // namespace lancret
