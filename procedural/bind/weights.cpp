#include "procedural/bind/weights.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>

#include "procedural/bind/settings.h"

namespace lancret {

double neighbour_reach(std::span<const double> distances, std::span<const double> shares,
                       std::size_t k, double last) {
    const double from = double(k), to = double(k + 1);
    double inverse = 0, mass = 0;
    for (std::size_t j = 0; j < distances.size() && mass < to; ++j) {
        const double before = mass;
        mass += shares[j];
        const double part = std::min(mass, to) - std::max(before, from);
        if (part > 0) inverse += part / std::min(distances[j], last);
    }
    const double left = to - std::max(mass, from);
    if (left > 0) inverse += left / last;
    return 1 / inverse;
}

WeightSource guide_weights(std::span<const double> distances,
                           std::span<const double> shares, double reach,
                           std::span<const double> facing, double exponent,
                           std::span<float> weights) {
    assert(weights.size() <= kMaxCandidates);
    std::ranges::fill(weights, 0.0f);
    const auto shared = std::ranges::find_if(shares, [](double e) { return e > 0; });
    if (shared == shares.end()) return WeightSource::none;
    const auto first = std::size_t(shared - shares.begin());
    const double nearest = distances[first];
    if (nearest <= 1e-7) {
        weights[first] = 1;
        return WeightSource::facing;
    }
    // Relative to the nearest, so that no power of a small distance overflows. If all are
    // as far as the reach, only their facing distinguishes them.
    const bool even = nearest >= reach * (1 - 1e-9);
    double sum = 0, faced = 0;
    std::array<double, kMaxCandidates> raw;
    for (std::size_t k = first; k < weights.size(); ++k) {
        const double near = even ? double(distances[k] <= reach * (1 + 1e-9))
                                 : nearest / distances[k] - nearest / reach;
        raw[k] = near > 0 ? std::pow(near, exponent) * shares[k] : 0;
        sum += raw[k];
        faced += raw[k] * std::max(0.0, facing[k]);
    }
    if (!(sum > 0)) return WeightSource::none;
    const double floor = std::max(0.0, kMinFacing - faced / sum);
    double total = 0;
    for (std::size_t k = first; k < weights.size(); ++k) {
        raw[k] *= std::max(0.0, facing[k]) + floor;
        total += raw[k];
    }
    for (std::size_t k = first; k < weights.size(); ++k) {
        weights[k] = float(raw[k] / total);
    }
    return faced > 0 ? WeightSource::facing : WeightSource::distance;
}

void keep_heaviest(std::span<float> weights, std::size_t k) {
    if (weights.size() <= k) return;
    std::array<float, kMaxCandidates> order;
    std::ranges::copy(weights, order.begin());
    const auto nth = order.begin() + std::ptrdiff_t(k);
    std::nth_element(order.begin(), nth, order.begin() + std::ptrdiff_t(weights.size()),
                     std::greater<>());
    const float gone = *nth;
    if (!(gone > 0)) return;
    double sum = 0;
    for (const float w : weights) sum += std::max(0.0, double(w) - gone);
    const auto heaviest = std::ranges::max_element(weights) - weights.begin();
    for (float& w : weights) {
        w = sum > 0 ? float(std::max(0.0, double(w) - gone) / sum) : 0.0f;
    }
    if (!(sum > 0)) weights[std::size_t(heaviest)] = 1;
}

}  // namespace lancret
