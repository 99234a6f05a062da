#include "procedural/expand/child_strands.h"

#include <algorithm>
#include <numeric>

#include "guides/base/cancel.h"

namespace lancret {

namespace {

/// Fills `out.first` with the strands in the order of their ids, and returns each child's
/// rank in that order, [children].
std::vector<std::uint32_t> rank_children(const Binding& binding,
                                         const ClassedGuides& guides, Strands& out) {
    std::vector<std::uint32_t> order(binding.size()), rank(binding.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::uint32_t i) { return binding.roots.id(i); });
    out.first.assign(binding.size() + 1, 0);
    for (std::uint32_t r = 0; r < order.size(); ++r) {
        rank[order[r]] = r;
        const int count = guides.classes.counts[guides.classes.of(binding, order[r])];
        out.first[r + 1] = out.first[r] + std::uint32_t(count) + 1;
    }
    return rank;
}

}  // namespace

Strands child_strands(const Binding& binding, const ClassedGuides& guides,
                      const ExpandSettings& settings) {
    Strands out;
    const std::vector<std::uint32_t> rank = rank_children(binding, guides, out);
    out.points.resize(out.first.back());
    out.thickness.resize(out.points.size());
    const Taper& taper = settings.taper;
    const auto write = [&](std::size_t i, std::span<const HelixState<float>> states) {
        const float width = binding.roots.width(i);
        const std::size_t first = out.first[rank[i]];
        for (std::size_t j = 0; j < states.size(); ++j) {
            const float s = float(j) / float(states.size() - 1);
            out.points[first + j] = binding.roots.positions[i] + states[j].position;
            out.thickness[first + j] =
                2 * width * (taper.root + (taper.tip - taper.root) * s);
        }
    };
    using Range = tbb::blocked_range<std::size_t>;
    each_class(
        guides.classes, binding, [&](std::size_t c, std::size_t first, std::size_t last) {
            cancellable_for(Range(first, last, settings.grain), [&](const Range& range) {
                each_strand(
                    {binding, guides.profiles[c], guides.kernel(c), settings.blend},
                    range.begin(), range.end(), write);
            });
        });
    return out;
}

}  // namespace lancret
