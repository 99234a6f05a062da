#pragma once

#include "guides/helix/helix.h"

namespace lancret {

/// Extends `box` by the whole of the helix that starts at `from` and goes on for `ds` >=
/// 0 (cm) at Darboux vector `u` (1/cm): exactly, by the places where its tangent lies
/// across an axis, which are where alpha + beta cos w s + gamma sin w s = 0.
void extend(Eigen::AlignedBox3d& box, const HelixState<double>& from, const Vec3& u,
            double ds);

}  // namespace lancret
