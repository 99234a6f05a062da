#pragma once
// A few classes of interval counts, so that straight strands need fewer points than
// curls.

#include <cstdint>
#include <vector>

#include "procedural/bind/binding.h"
#include "procedural/kernels/kernel_guides.h"

namespace lancret {

inline constexpr std::size_t kMaxClasses = 32;

/// Classes are chosen per guide, before any child is grown: a child has the class of its
/// heaviest guide, in every chunk and at every density.
struct StrandClasses {
    std::vector<int> counts;  ///< [classes <= kMaxClasses], intervals per strand,
                              ///< strictly descending
    std::vector<std::uint8_t> of_guide{};  ///< [guides]; empty: all have class 0

    std::size_t size() const { return counts.size(); }
    /// The class of child i.
    std::size_t of(const Binding& binding, std::size_t i) const;
};

/// The guide with the largest weight in child i, the first if several share it.
std::uint32_t heaviest_guide(const Binding& binding, std::size_t i);

/// The number of children of `binding` in each class, [classes]. Throws
/// std::invalid_argument if the children are not in the order of in_class_order.
std::vector<std::uint32_t> class_sizes(const StrandClasses& classes,
                                       const Binding& binding);

/// The children sorted by class, finest first, then by id: the order that `expand`
/// requires. Keeps the report.
Binding in_class_order(Binding binding, const StrandClasses& classes);

/// The guides of one time, sampled for the strands of each class.
struct ClassedGuides {
    StrandClasses classes;
    std::vector<GuideProfiles<float>> profiles;  ///< [classes], at their counts
    std::vector<KernelGuides> kernels;  ///< [classes], for the blend; empty: the scalar
                                        ///< blends are used

    const GuideProfiles<float>& finest() const { return profiles.front(); }
    const KernelGuides& kernel(std::size_t c) const;
};

/// `normals` are the scalp's at the guides' roots, at the time of `guides`.
ClassedGuides classed_guides(const Guides& guides, const StrandClasses& classes,
                             std::span<const Vec3f> normals, Blend blend);

/// Calls visit(class, first, last) with the range of children of every class that has
/// any.
template <class Visit>
void each_class(const StrandClasses& classes, const Binding& binding,
                const Visit& visit) {
    std::size_t first = 0;
    const std::vector<std::uint32_t> sizes = class_sizes(classes, binding);
    for (std::size_t c = 0; c < sizes.size(); ++c) {
        if (sizes[c] > 0) visit(c, first, first + sizes[c]);
        first += sizes[c];
    }
}

}  // namespace lancret
