#include "procedural/kernels/strand_kernels.h"

#include "procedural/kernels/position_kernel.h"

namespace lancret {

bool has_kernel(Blend blend, CurveBasis basis) {
    return blend == Blend::position && basis == CurveBasis::bspline;
}

void expand_strands(const KernelInput& in, const KernelOutput& out) {
    expand_positions(in, out);
}

}  // namespace lancret
