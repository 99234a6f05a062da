#pragma once
// How much each of its neighbours has to say in a child.

#include <span>

#include "guides/types.h"

namespace lancret {

/// Weights of a child's nearest guides [TW99, Sec. 4.3 and Eq. 49]:
///     w_k ~ f(|x - x_k|) (S.T_k) H(S.T_k),   f(d) = ((1/d - 1/reach)+)^a,
/// with Shepard's falloff to `reach`, the distance of the next guide beyond them, in
/// place of the bare power: a guide that leaves the set of neighbours leaves it with
/// weight zero, so weights are continuous in x. `distances` ascend, cm; `facing` holds
/// S.T_k. A reach of infinity gives the paper's own power law. Where a root coincides
/// with a guide's, that guide has all the weight. Returns false, with the nearest guide
/// alone, when every weight vanishes.
bool guide_weights(std::span<const double> distances, double reach,
                   std::span<const double> facing, double exponent,
                   std::span<float> weights);

}  // namespace lancret
