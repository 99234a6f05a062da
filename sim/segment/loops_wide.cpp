// Compiled for AVX2 on x86-64 (sim/CMakeLists.txt).
#define LANCRET_SIMD wide
#include "sim/segment/loops_code.h"

namespace lancret {

const SegmentLoops kWideLoops = wide::kLoops;

}  // namespace lancret
