#pragma once
// Numbers in half precision, by which pictures are stored.

#include <cstdint>

namespace lancret {

/// The nearest half, and the float that it is. Values of half precision stay finite: the
/// largest half is 65504.
float rounded_to_half(float x);

}  // namespace lancret
