#include "procedural/kernels/strand_kernels.h"

#include "procedural/kernels/curl_kernel.h"
#include "procedural/kernels/position_kernel.h"

namespace lancret {

bool is_curl(Blend blend) {
    return blend == Blend::detail || blend == Blend::nearest || blend == Blend::option1 ||
           blend == Blend::option1_anchored;
}

bool has_kernel(Blend blend, CurveBasis basis) {
    return is_curl(blend) || (blend == Blend::position && basis == CurveBasis::bspline);
}

void synthesize_strands(const KernelInput& in, std::size_t first, std::size_t count,
                        std::span<HelixState<float>> states) {
    synthesize_curls(in, first, count, states);
}

void expand_strands(const KernelInput& in, const KernelOutput& out) {
    (is_curl(in.blend) ? expand_curls : expand_positions)(in, out);
}

}  // namespace lancret
