#pragma once
// Gauss points along a segment of any turn.

#include <algorithm>
#include <cmath>

#include "sim/segment/gauss_legendre.h"

namespace lancret {

/// Calls visit(u, w) at the Gauss points of a segment of length `length` (cm) that turns
/// by `turn` (rad): u is the arc length from its start, w the weight, both cm. A segment
/// that turns too far for one rule is cut into equal panels, at most 10^4.
template <class Visit>
void over_segment(double length, double turn, Visit&& visit) {
    constexpr double kPanelTurn = 24;
    const int panels = int(std::clamp(std::ceil(turn / kPanelTurn), 1., 1e4));
    const double width = length / panels;
    const GaussRule rule = gauss_rule(gauss_points(turn / panels));
    for (int panel = 0; panel < panels; ++panel) {
        for (std::size_t g = 0; g < rule.nodes.size(); ++g) {
            visit((panel + rule.nodes[g]) * width, rule.weights[g] * width);
        }
    }
}

}  // namespace lancret
