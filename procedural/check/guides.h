#pragma once
// The guides of one time, looked at: what a simulation may have done to them.

#include <span>

#include "procedural/check/check.h"

namespace lancret {

/// What was found on the guides of one time.
struct GuideCheck {
    bool finite = true;            ///< every root, frame and curvature
    double orthogonality = 0;      ///< max |R^T R - I| over the root frames
    double length_change = 0;      ///< relative, of any segment since rest, at most
    double root_distance = 0;      ///< cm, of a root from its place on the scalp, at most
    std::uint32_t worst_root = 0;  ///< the guide that this is
    bool root_applies = true;      ///< false where guides may have stood off the scalp
};

/// Compares the guides of one time with those at rest and with where the scalp has their
/// roots then, [guides], cm.
GuideCheck check_guides(const Guides& now, const Guides& rest,
                        std::span<const Vec3> scalp_roots);

/// Whether the guides keep `orthogonality` and `root` of the tolerances; lengths keep
/// their bits.
bool passes(const GuideCheck& check, const CheckTolerances& tolerances);

}  // namespace lancret
