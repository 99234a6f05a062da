#pragma once
// The check of guides at one time, which a simulation may have changed.

#include <span>

#include "procedural/check/check.h"

namespace lancret {

/// The measurements of the guides at one time, each the largest over the guides.
struct GuideCheck {
    bool finite = true;            ///< every root, frame and curvature
    double orthogonality = 0;      ///< max |R^T R - I| of the root frames
    double length_change = 0;      ///< relative, of a segment since rest
    double root_distance = 0;      ///< cm, of a root from its place on the scalp
    std::uint32_t worst_root = 0;  ///< the guide of that root
    bool root_applies = true;  ///< false if guides may have stood off the scalp at rest
};

/// Compares the guides with those at rest and with the places of their roots on the scalp
/// at that time, [guides], cm. Throws std::invalid_argument if their numbers differ.
GuideCheck check_guides(const Guides& now, const Guides& rest,
                        std::span<const Vec3> scalp_roots);

/// Whether the guides keep the tolerances `orthogonality` and `root`; their lengths must
/// keep their bits.
bool passes(const GuideCheck& check, const CheckTolerances& tolerances);

}  // namespace lancret
