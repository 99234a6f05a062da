#include "procedural/check_values.h"

#include <oneapi/tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "guides/cancel.h"
#include "procedural/check_strand.h"

namespace lancret {

namespace {

using States = std::span<const HelixState<float>>;

float finite(double value) {
    constexpr float kMost = std::numeric_limits<float>::max();
    return std::isfinite(value) ? float(std::clamp<double>(value, -kMost, kMost)) : kMost;
}

/// `per_strand` values of every child from its places: figure(states, j).
template <class Figure>
StrandValues values_of(const Binding& binding, const GuideProfiles<float>& profiles,
                       Blend blend, bool at_places, const Figure& figure) {
    StrandValues out;
    out.at_places = at_places;
    out.per_strand = std::uint32_t(profiles.count + (at_places ? 1 : 0));
    out.values.resize(binding.size() * out.per_strand);
    const KernelGuides guides = kernel_guides(profiles, binding.guide_normals, blend);
    const auto put = [&](std::size_t i, States states) {
        for (std::uint32_t j = 0; j < out.per_strand; ++j) {
            out.values[i * out.per_strand + j] = finite(figure(states, j));
        }
    };
    cancellable_for(tbb::blocked_range<std::size_t>(0, binding.size(), 256),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                        each_strand(binding, profiles, guides, blend, range.begin(),
                                    range.end(), put);
                    });
    return out;
}

}  // namespace

float StrandValues::at(std::uint32_t strand, float along) const {
    const float* own = values.data() + std::size_t(strand) * per_strand;
    if (per_strand == 1) return own[0];
    const std::uint32_t intervals = at_places ? per_strand - 1 : per_strand;
    const float place = std::clamp(along, 0.0f, 1.0f) * float(intervals);
    const std::uint32_t j = std::min(std::uint32_t(place), intervals - 1);
    if (!at_places) return own[j];
    const float share = place - float(j);
    return (1 - share) * own[j] + share * own[j + 1];
}

StrandValues length_error_values(const CheckReport& report) {
    StrandValues out;
    out.values.reserve(report.strands.size());
    for (const StrandCheck& strand : report.strands) {
        out.values.push_back(finite(std::abs(double(strand.length_error))));
    }
    return out;
}

StrandValues orthogonality_values(const Binding& binding,
                                  const GuideProfiles<float>& profiles, Blend blend) {
    return values_of(binding, profiles, blend, true, [](States states, std::size_t j) {
        return orthogonality_error(std::span(&states[j], 1));
    });
}

StrandValues curvature_values(const Binding& binding,
                              const GuideProfiles<float>& profiles, Blend blend) {
    return values_of(binding, profiles, blend, false, [](States states, std::size_t j) {
        return measured_interval(states[j], states[j + 1]).kappa;
    });
}

StrandValues torsion_values(const Binding& binding, const GuideProfiles<float>& profiles,
                            Blend blend) {
    return values_of(binding, profiles, blend, false, [](States states, std::size_t j) {
        return measured_interval(states[j], states[j + 1]).tau;
    });
}

bool has_torsion(Blend blend) {
    return blend != Blend::position && blend != Blend::option3;
}

StrandValues leading_guide_values(const Binding& binding) {
    StrandValues out;
    const auto n = std::size_t(binding.neighbours);
    out.values.reserve(binding.size());
    for (std::size_t i = 0; i < binding.size(); ++i) {
        const std::span weights(&binding.weights[i * n], n);
        const auto heaviest = std::ranges::max_element(weights) - weights.begin();
        out.values.push_back(float(binding.guides[i * n + std::size_t(heaviest)]));
    }
    return out;
}

}  // namespace lancret
