#include "render_test/image/half_values.h"

#include <half.h>

#include <algorithm>

namespace lancret {

float rounded_to_half(float x) { return half(std::clamp(x, -65504.0f, 65504.0f)); }

}  // namespace lancret
