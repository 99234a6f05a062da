#pragma once
// A child's guides and weights, without the turns.

#include "procedural/bind/binding.h"

namespace lancret {

struct LightChild {
    std::uint32_t guides[kMaxNeighbours];  ///< those with a weight
    float weights[kMaxNeighbours];         ///< > 0, sum 1
    std::size_t count = 0;
    std::size_t heaviest = 0;  ///< the first of them
};

/// Child i: the numbers that bound_child has.
inline LightChild light_child(const Binding& binding, std::size_t i) {
    LightChild out;
    const std::size_t k = std::size_t(binding.neighbours);
    float sum = 0;
    for (std::size_t j = i * k; j < (i + 1) * k; ++j) {
        if (!(binding.weights[j] > 0)) continue;
        out.guides[out.count] = binding.guides[j];
        out.weights[out.count] = binding.weights[j];
        sum += binding.weights[j];
        ++out.count;
    }
    for (std::size_t j = 0; j < out.count; ++j) {
        out.weights[j] /= sum;
        if (out.weights[j] > out.weights[out.heaviest]) out.heaviest = j;
    }
    return out;
}

}  // namespace lancret
