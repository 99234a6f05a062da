#include "procedural/expand/strand_classes.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace lancret {

std::uint32_t heaviest_guide(const Binding& binding, std::size_t i) {
    const auto n = std::size_t(binding.neighbours);
    const float* const weights = &binding.weights[i * n];
    return binding
        .guides[i * n + std::size_t(std::max_element(weights, weights + n) - weights)];
}

std::size_t StrandClasses::of(const Binding& binding, std::size_t i) const {
    return of_guide.empty() ? 0 : of_guide[heaviest_guide(binding, i)];
}

std::vector<std::uint32_t> class_sizes(const StrandClasses& classes,
                                       const Binding& binding) {
    std::vector<std::uint32_t> out(classes.size(), 0);
    if (classes.of_guide.empty()) {
        out[0] = std::uint32_t(binding.size());
        return out;
    }
    std::size_t before = 0;
    for (std::size_t i = 0; i < binding.size(); ++i) {
        const std::size_t c = classes.of(binding, i);
        if (c < before) {
            throw std::invalid_argument(
                "the children are not in the order of their classes");
        }
        before = c;
        ++out[c];
    }
    return out;
}

Binding in_class_order(Binding binding, const StrandClasses& classes) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> order(binding.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = {std::uint32_t(classes.of(binding, i)), binding.roots.id(i)};
    }
    if (std::ranges::is_sorted(order)) return binding;
    std::vector<std::uint32_t> which(order.size());
    std::iota(which.begin(), which.end(), 0u);
    std::ranges::sort(which, {}, [&](std::uint32_t i) { return order[i]; });
    Binding out = picked(binding, which);
    out.report = binding.report;
    return out;
}

const KernelGuides& ClassedGuides::kernel(std::size_t c) const {
    static const KernelGuides kNone;
    return kernels.empty() ? kNone : kernels[c];
}

ClassedGuides classed_guides(const Guides& guides, const StrandClasses& classes,
                             std::span<const Vec3f> normals, Blend blend) {
    ClassedGuides out;
    out.classes = classes;
    for (const int count : classes.counts) {
        out.profiles.push_back(guide_profiles<float>(guides, count));
        out.kernels.push_back(kernel_guides(out.profiles.back(), normals, blend));
    }
    return out;
}

}  // namespace lancret
