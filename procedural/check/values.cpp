#include "procedural/check/values.h"

#include <oneapi/tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "guides/base/cancel.h"
#include "procedural/check/strand.h"

namespace lancret {

namespace {

using States = std::span<const HelixState<float>>;

float finite(double value) {
    constexpr float kMax = std::numeric_limits<float>::max();
    return std::isfinite(value) ? float(std::clamp<double>(value, -kMax, kMax)) : kMax;
}

/// figure(states, j) for every place or interval j of every child, at its class.
template <class Figure>
StrandValues values_of(const Binding& binding, const ClassedGuides& guides, Blend blend,
                       bool at_places, const Figure& figure) {
    StrandValues out;
    out.at_places = at_places;
    out.first.push_back(0);
    using Range = tbb::blocked_range<std::size_t>;
    each_class(
        guides.classes, binding, [&](std::size_t c, std::size_t first, std::size_t last) {
            const std::size_t count = std::size_t(guides.profiles[c].count) + at_places;
            for (std::size_t i = first; i < last; ++i) {
                out.first.push_back(out.first.back() + count);
            }
            out.values.resize(out.first.back());
            const auto write = [&](std::size_t i, States states) {
                for (std::size_t j = 0; j < count; ++j) {
                    out.values[out.first[i] + j] = finite(figure(states, j));
                }
            };
            cancellable_for(Range(first, last, 256), [&](const Range& range) {
                each_strand({binding, guides.profiles[c], guides.kernel(c), blend},
                            range.begin(), range.end(), write);
            });
        });
    return out;
}

}  // namespace

StrandValues length_error_values(const CheckReport& report) {
    StrandValues out;
    out.values.reserve(report.strands.size());
    for (const StrandCheck& strand : report.strands) {
        out.values.push_back(finite(std::abs(double(strand.length_error))));
    }
    return out;
}

StrandValues orthogonality_values(const Binding& binding, const ClassedGuides& guides,
                                  Blend blend) {
    return values_of(binding, guides, blend, true, [](States states, std::size_t j) {
        return orthogonality_error(std::span(&states[j], 1));
    });
}

StrandValues curvature_values(const Binding& binding, const ClassedGuides& guides,
                              Blend blend) {
    return values_of(binding, guides, blend, false, [](States states, std::size_t j) {
        return measured_interval(states[j], states[j + 1]).kappa;
    });
}

StrandValues torsion_values(const Binding& binding, const ClassedGuides& guides,
                            Blend blend) {
    return values_of(binding, guides, blend, false, [](States states, std::size_t j) {
        return measured_interval(states[j], states[j + 1]).tau;
    });
}

}  // namespace lancret
