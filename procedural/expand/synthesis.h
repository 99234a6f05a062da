#pragma once
// Children before their control points are made: frames and places.

#include <algorithm>
#include <span>
#include <vector>

#include "procedural/bind/child.h"
#include "procedural/curves/control_points.h"
#include "procedural/kernels/kernel_guides.h"

namespace lancret {

/// How the strands of a blend go on beyond their ends. The places of `position` are
/// weighted sums, and so are its ends: of frames that are carried along they know
/// nothing.
constexpr Ends ends_of(Blend blend) {
    return blend == Blend::position ? Ends::parabola : Ends::helix;
}

/// Children [first, first + count) as `expand` synthesises them: by the kernel where
/// there is one with frames, else by the scalar blends. profiles.count + 1 places of each
/// in `states`.
void synthesize(const Binding& binding, const GuideProfiles<float>& profiles,
                const KernelGuides& guides, Blend blend, std::size_t first,
                std::size_t count, std::span<HelixState<float>> states);

/// visit(i, places of child i) for the children [first, last), which are synthesised some
/// at a time.
template <class Visit>
void each_strand(const Binding& binding, const GuideProfiles<float>& profiles,
                 const KernelGuides& guides, Blend blend, std::size_t first,
                 std::size_t last, const Visit& visit) {
    constexpr std::size_t kTogether = 64;
    const std::size_t places = std::size_t(profiles.count) + 1;
    std::vector<HelixState<float>> several(std::min(kTogether, last - first) * places);
    for (std::size_t i = first; i < last; i += kTogether) {
        const std::size_t count = std::min(kTogether, last - i);
        synthesize(binding, profiles, guides, blend, i, count, several);
        for (std::size_t s = 0; s < count; ++s) {
            visit(i + s, std::span<const HelixState<float>>(several).subspan(s * places,
                                                                             places));
        }
    }
}

}  // namespace lancret
