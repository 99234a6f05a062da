#include "procedural/expand/synthesis.h"

#include "procedural/kernels/instruction_set.h"
#include "procedural/kernels/strand_kernels.h"

namespace lancret {

namespace {

bool has_curl_kernel(Blend blend) { return traits_of(blend).kernel == BlendKernel::curl; }

}  // namespace

void synthesize(const SynthesisInput& in, std::size_t first, std::size_t count,
                std::span<HelixState<float>> states) {
    if (in.guides.size > 0 && has_curl_kernel(in.blend)) {
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

std::string synthesis_code(Blend blend) {
    return has_curl_kernel(blend) ? std::string("kernel ") + kernel_instruction_set()
                                  : "scalar";
}

}  // namespace lancret
