#pragma once
// How finely strands are cut: a few classes of interval counts, so that a straight strand
// does not pay for another's curls.

#include <cstdint>
#include <vector>

#include "procedural/bind/binding.h"
#include "procedural/kernels/kernel_guides.h"

namespace lancret {

inline constexpr std::size_t kMaxClasses = 32;

/// Classes are chosen by guide, before any child is grown: a child has that of its
/// heaviest guide, in every chunk and at every density.
struct StrandClasses {
    std::vector<int> counts;  ///< [classes <= kMaxClasses], intervals a strand, finest
                              ///< first, each once
    std::vector<std::uint8_t> of_guide{};  ///< [guides]; or empty: all have the first

    std::size_t size() const { return counts.size(); }
    /// The class of child i.
    std::size_t of(const Binding& binding, std::size_t i) const;
};

/// The first of child i's guides with the largest weight.
std::uint32_t heaviest_guide(const Binding& binding, std::size_t i);

/// How many children of `binding` each class has. Throws std::invalid_argument where they
/// do not stand as in_class_order puts them.
std::vector<std::uint32_t> class_sizes(const StrandClasses& classes,
                                       const Binding& binding);

/// The children by their class, finest first, and in it by their ids, as `expand` wants
/// them. The report is kept.
Binding in_class_order(Binding binding, const StrandClasses& classes);

/// The guides of one time as the strands of each class read them.
struct ClassedGuides {
    StrandClasses classes;
    std::vector<GuideProfiles<float>> profiles;  ///< [classes], on their counts
    std::vector<KernelGuides> kernels;  ///< [classes], of the blend; or empty: the scalar
                                        ///< blends serve

    const GuideProfiles<float>& finest() const { return profiles.front(); }
    const KernelGuides& kernel(std::size_t c) const;
};

/// `normals` are the scalp's at the guides' roots, at the time of `guides`.
ClassedGuides classed_guides(const Guides& guides, const StrandClasses& classes,
                             std::span<const Vec3f> normals, Blend blend);

/// One class of all strands, with its kernel.
ClassedGuides one_class(const GuideProfiles<float>& profiles,
                        std::span<const Vec3f> normals, Blend blend);

/// visit(class, first, last): the children of `binding` that each class has, where it has
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
