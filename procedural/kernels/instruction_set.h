#pragma once

namespace lancret {

/// The instruction set that the kernels run with on this machine, such as "AVX2".
const char* kernel_instruction_set();

}  // namespace lancret
