#pragma once

#include "guides/helix/helix.h"

namespace lancret {

/// Extends `box` to contain the helix that starts at `from` with Darboux vector `u`
/// (1/cm) and length `ds` >= 0 (cm). Exact: extremes lie where the tangent is across an
/// axis, alpha + beta cos w s + gamma sin w s = 0.
void extend(Eigen::AlignedBox3d& box, const HelixState<double>& from, const Vec3& u,
            double ds);

}  // namespace lancret
