#pragma once
// Exact reconstruction of a Super-Helix at any arc length, and its derivatives with
// respect to its curvatures.

#include <span>
#include <vector>

#include "guides/helix/guides.h"

namespace lancret {

/// One Super-Helix: a root and views of its segments.
struct SuperHelix {
    HelixState<double> root;
    std::span<const double> lengths;   ///< [segments], cm
    std::span<const Vec3> curvatures;  ///< [segments], 1/cm
};

inline SuperHelix super_helix(const Guides& guides, std::size_t g) {
    return {guides.root(g), guides.lengths_of(g), guides.curvatures_of(g)};
}

/// Calls visit(i, segment, state) with the exact state at each arc length s[i], cm. `s`
/// ascends. Below 0 and beyond the length the first and last helix are extended. A joint
/// belongs to the segment that ends there.
template <class Visit>
void sample(const SuperHelix& helix, std::span<const double> s, Visit&& visit) {
    HelixState<double> joint = helix.root;
    double start = 0;
    std::size_t segment = 0;
    const std::size_t last = helix.lengths.size() - 1;
    for (std::size_t i = 0; i < s.size(); ++i) {
        while (segment < last && s[i] > start + helix.lengths[segment]) {
            advance<double>(joint, helix.curvatures[segment], helix.lengths[segment]);
            start += helix.lengths[segment++];
        }
        HelixState<double> state = joint;
        advance<double>(state, helix.curvatures[segment], s[i] - start);
        visit(i, segment, state);
    }
}

/// The exact state at arc length s, cm.
HelixState<double> state_at(const SuperHelix& helix, double s);

/// Positions at the arc lengths `s` with their derivatives: row block i, [3 x 3
/// segments], of `jacobian` is d(position i)/d(curvatures), columns in the order k0, k1,
/// k2 of segment 0, then of segment 1 and so on [Bergbom07, Sec. 4.3, generalised from
/// one point to many]. `positions` has 3 rows per sample. Both are resized if needed, so
/// they can be reused.
void positions_with_jacobian(const SuperHelix& helix, std::span<const double> s,
                             Eigen::VectorXd& positions, Eigen::MatrixXd& jacobian);

}  // namespace lancret
