#include "procedural/expand/synthesis.h"

#include "procedural/kernels/strand_kernels.h"

namespace lancret {

void synthesize(const Binding& binding, const GuideProfiles<float>& profiles,
                const KernelGuides& guides, Blend blend, std::size_t first,
                std::size_t count, std::span<HelixState<float>> states) {
    if (guides.size > 0 && is_curl(blend)) {
        const KernelInput in{binding, profiles, guides, blend, CurveBasis::bspline, {}};
        synthesize_strands(in, first, count, states);
        return;
    }
    const std::size_t places = std::size_t(profiles.count) + 1;
    for (std::size_t s = 0; s < count; ++s) {
        synthesize_child<float>(binding, profiles, blend, first + s,
                                states.subspan(s * places, places));
    }
}

}  // namespace lancret
