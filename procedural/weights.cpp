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
    // Relative to the nearest, so that no power of a small distance overflows.
    double sum = 0;
    std::array<double, 64> raw;
    for (std::size_t k = 0; k < weights.size(); ++k) {
        const double near = distances[0] / distances[k] - distances[0] / reach;
        raw[k] = std::pow(std::max(0.0, near), exponent) * std::max(0.0, facing[k]);
        sum += raw[k];
    }
    if (!(sum > 1e-12)) {
        weights[0] = 1;
        return false;
    }
    for (std::size_t k = 0; k < weights.size(); ++k) weights[k] = float(raw[k] / sum);
    return true;
}

}  // namespace lancret
