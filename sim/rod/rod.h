#pragma once
// One Super-Helix as input of the dynamics.

#include <span>
#include <vector>

#include "guides/motion/root_motion.h"
#include "sim/rod/section.h"

namespace lancret {

/// The properties of a rod that do not change while it moves.
struct Rod {
    std::span<const double> lengths;  ///< [segments], cm, > 0
    std::span<const Vec3> natural;    ///< [segments], curvatures without load, 1/cm
    RodSection section;

    int segments() const { return int(lengths.size()); }
};

/// The pose of a rod at one time; owns its arrays.
struct RodPose {
    HelixState<double> root;
    std::vector<Vec3> curvatures;  ///< [segments], 1/cm
};

/// The pose and motion of a rod. The generalised coordinates q are all (k0, k1, k2).
struct RodState {
    RootMotion root;
    std::span<const Vec3> curvatures;  ///< [segments], q, 1/cm
    std::span<const Vec3> rates;       ///< [segments], q', 1/(cm s)
};

}  // namespace lancret
