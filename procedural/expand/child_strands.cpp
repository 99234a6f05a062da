#include "procedural/expand/child_strands.h"

#include <algorithm>
#include <numeric>

#include "guides/base/cancel.h"

namespace lancret {

namespace {

/// Says where each child's points go among those of all: to `out.first` in the order of
/// the ids, and the child's place in that order. [children]
std::vector<std::uint32_t> place_children(const Binding& binding,
                                          const ClassedGuides& guides, Strands& out) {
    std::vector<std::uint32_t> order(binding.size()), place(binding.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::uint32_t i) { return binding.roots.id(i); });
    out.first.assign(binding.size() + 1, 0);
    for (std::uint32_t at = 0; at < order.size(); ++at) {
        place[order[at]] = at;
        const int count = guides.classes.counts[guides.classes.of(binding, order[at])];
        out.first[at + 1] = out.first[at] + std::uint32_t(count) + 1;
    }
    return place;
}

}  // namespace

Strands child_strands(const Binding& binding, const ClassedGuides& guides,
                      const ExpandSettings& settings) {
    Strands out;
    const std::vector<std::uint32_t> place = place_children(binding, guides, out);
    out.points.resize(out.first.back());
    out.thickness.resize(out.points.size());
    const auto [root, tip] = settings.taper;
    const auto put = [&](std::size_t i, std::span<const HelixState<float>> states) {
        const float width = binding.roots.width(i);
        const std::size_t at = out.first[place[i]];
        for (std::size_t j = 0; j < states.size(); ++j) {
            const float s = float(j) / float(states.size() - 1);
            out.points[at + j] = binding.roots.positions[i] + states[j].position;
            out.thickness[at + j] = 2 * width * (root + (tip - root) * s);
        }
    };
    using Range = tbb::blocked_range<std::size_t>;
    each_class(
        guides.classes, binding, [&](std::size_t c, std::size_t first, std::size_t last) {
            cancellable_for(Range(first, last, settings.chunk), [&](const Range& chunk) {
                each_strand(
                    {binding, guides.profiles[c], guides.kernel(c), settings.blend},
                    chunk.begin(), chunk.end(), put);
            });
        });
    return out;
}

}  // namespace lancret
