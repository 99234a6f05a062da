#include "guides/helix/helix_box.h"

#include <cmath>

#include <algorithm>

namespace lancret {

void extend(Eigen::AlignedBox3d& box, const HelixState<double>& from, const Vec3& u,
            double ds) {
    const auto place = [&](double s) -> Vec3 {
        return from.position + from.frame * helix_step<double>(u, s).displacement;
    };
    const Vec3 end = place(ds);
    box.extend(from.position).extend(end);
    // A curve deviates from the chord between its ends, at equal shares of the length, by
    // at most max |r''| ds^2 / 8. If the box contains that much, it contains the helix.
    const double rate = u.norm(), stray = std::hypot(u.y(), u.z()) * ds * ds / 8;
    if (!(rate * ds > 1e-12)) return;
    const Vec3 axis = u / rate, round = axis.cross(Vec3::UnitX());
    for (int e = 0; e < 3; ++e) {
        const double low = std::min(from.position[e], end[e]) - stray;
        const double high = std::max(from.position[e], end[e]) + stray;
        if (low >= box.min()[e] && high <= box.max()[e]) continue;
        // e.T(s) = alpha + beta cos(rate s) + gamma sin(rate s)
        const Vec3 direction = from.frame.row(e);
        const double alpha = direction.dot(axis) * axis.x();
        const double beta = direction.x() - alpha, gamma = direction.dot(round);
        const double size = std::hypot(beta, gamma);
        if (!(size > std::abs(alpha))) continue;
        const double phase = std::atan2(gamma, beta), half = std::acos(-alpha / size);
        constexpr double kTurn = 2 * kPi;
        for (const double zero : {phase - half, phase + half}) {
            double angle = zero - kTurn * std::floor(zero / kTurn);
            // A helix advances steadily: the first and the last turn hold the extremes.
            const double last = angle + kTurn * std::floor((rate * ds - angle) / kTurn);
            if (!(angle <= rate * ds)) continue;
            box.extend(place(angle / rate)).extend(place(last / rate));
        }
    }
}

}  // namespace lancret
