#pragma once
// One Super-Helix as the dynamics sees it.

#include <span>
#include <vector>

#include "guides/motion/root_motion.h"
#include "sim/rod/section.h"

namespace lancret {

/// What a rod is made of: it does not change while the rod moves.
struct Rod {
    std::span<const double> lengths;  ///< [segments], cm, > 0
    std::span<const Vec3> natural;    ///< [segments], curvatures without load, 1/cm
    RodSection section;

    int segments() const { return int(lengths.size()); }
};

/// Where a rod is at a time, by itself.
struct RodPose {
    HelixState<double> root;
    std::vector<Vec3> curvatures;  ///< [segments], 1/cm
};

/// Where a rod is and how it moves. The generalised coordinates q are all (k0, k1, k2).
struct RodState {
    RootMotion root;
    std::span<const Vec3> curvatures;  ///< [segments], q, 1/cm
    std::span<const Vec3> rates;       ///< [segments], q', 1/(cm s)
};

}  // namespace lancret
