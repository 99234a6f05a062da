#include "procedural/expand/synthesis.h"

#include "procedural/kernels/strand_kernels.h"

namespace lancret {

void synthesize(const SynthesisInput& in, std::size_t first, std::size_t count,
                std::span<HelixState<float>> states) {
    if (in.guides.size > 0 && traits_of(in.blend).kernel == BlendKernel::curl) {
        synthesize_strands({.binding = in.binding,
                            .profiles = in.profiles,
                            .guides = in.guides,
                            .blend = in.blend,
                            .basis = CurveBasis::bspline,
                            .taper = {}},
                           first, count, states);
        return;
    }
    const std::size_t places = std::size_t(in.profiles.count) + 1;
    for (std::size_t s = 0; s < count; ++s) {
        synthesize_child<float>(in.binding, in.profiles, in.blend, first + s,
                                states.subspan(s * places, places));
    }
}

}  // namespace lancret
