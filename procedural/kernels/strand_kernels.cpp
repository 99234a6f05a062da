#include "procedural/kernels/strand_kernels.h"

#include "procedural/kernels/curl_kernel.h"
#include "procedural/kernels/position_kernel.h"

namespace lancret {

bool has_kernel(Blend blend, CurveBasis basis) {
    switch (traits_of(blend).kernel) {
        case BlendKernel::none:
            return false;
        case BlendKernel::curl:
            return true;
        case BlendKernel::position:
            return basis == CurveBasis::bspline;
    }
    return false;
}

void synthesize_strands(const KernelInput& in, std::size_t first, std::size_t count,
                        std::span<HelixState<float>> states) {
    synthesize_curls(in, first, count, states);
}

void expand_strands(const KernelInput& in, const KernelOutput& out) {
    const bool curl = traits_of(in.blend).kernel == BlendKernel::curl;
    (curl ? expand_curls : expand_positions)(in, out);
}

}  // namespace lancret
