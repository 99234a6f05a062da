#pragma once
// Dragging a point of a strand, as a comb or a translate tool does. The strand keeps its
// length exactly, since only curvatures change.

#include <limits>
#include <vector>

#include "guides/helix/super_helix.h"

namespace lancret {

struct TranslationSettings {
    /// Segments that may bend, first to last inclusive; those beyond the point have no
    /// effect.
    int first_segment = 0;
    int last_segment = std::numeric_limits<int>::max();
    Vec3 stiffness{0.6757, 1, 1};  ///< relative, against (k0, k1, k2)
    double tolerance = 1e-6;       ///< cm from the target at which iterations stop
    int max_iterations = 200;
};

struct TranslationReport {
    bool reached = false;
    double distance = 0;  ///< final distance of the point from the target, cm
    int iterations = 0;
};

/// Sets `curvatures` to those of `helix`, changed so that the point at arc length s (cm,
/// in [0, length]) moves to `target` (cm), by Levenberg-Marquardt on the squared distance
/// [Bergbom07, Eq. 4.63-4.67, corrected; without the term of second derivatives]. Each
/// iteration takes the change with the least bending energy. If the target is out of
/// reach, the point ends as near to it as the iterations get. Throws
/// std::invalid_argument if s, the target, a stiffness or the segments are invalid.
TranslationReport translate_point(const SuperHelix& helix, double s, const Vec3& target,
                                  const TranslationSettings& settings,
                                  std::vector<Vec3>& curvatures);

}  // namespace lancret
