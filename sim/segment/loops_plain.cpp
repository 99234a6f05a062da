#define LANCRET_SIMD plain
#include "sim/segment/loops_code.h"

namespace lancret {

const SegmentLoops kPlainLoops = plain::kLoops;

}  // namespace lancret
