#pragma once
// Half precision, in which images are stored.

namespace lancret {

/// The half nearest to `x`, as a float. The result is finite: `x` is clamped to the
/// largest half, 65504.
float rounded_to_half(float x);

}  // namespace lancret
