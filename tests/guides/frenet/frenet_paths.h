#pragma once
// Paths in closed form for the tests of Frenet-Serret analysis, and their round trip.

#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "guides/frenet/frenet_analysis.h"
#include "guides/helix/helix.h"

namespace lancret {

/// A root that is aligned with no axis.
inline HelixState<double> skew_root() {
    return {helix_step<double>(Vec3(0.3, -1.1, 0.7), 1).rotation, Vec3(1, -2, 3)};
}

using Path = std::function<CurvePoint(double)>;

/// A helix of radius a and pitch 2 pi b; left-handed if b < 0. kappa = a / (a^2 +
/// b^2), tau = b / (a^2 + b^2).
inline CurvePoint helix(double v, double a, double b) {
    const double c = a * std::cos(v), s = a * std::sin(v);
    return {{c, s, b * v}, {-s, c, b}, {-c, -s, 0}, {s, -c, 0}};
}

/// kappa and tau both vary: kappa = 2 sqrt(9 v^4 + 9 v^2 + 1) / (9 v^4 + 4 v^2 + 1)^1.5.
inline CurvePoint twisted_cubic(double v) {
    return {{v, v * v, v * v * v}, {1, 2 * v, 3 * v * v}, {0, 2, 6 * v}, {0, 0, 6}};
}

/// y = x^3: kappa = 6 x / (1 + 9 x^4)^1.5 changes sign at 0.
inline CurvePoint cubic_inflection(double x) {
    return {{x, x * x * x, 0}, {1, 3 * x * x, 0}, {0, 6 * x, 0}, {0, 6, 0}};
}

/// Samples at equal steps of the parameter, and the arc lengths between them by Gauss
/// quadrature on 40 parts per step (error far below 1e-12).
struct Sampled {
    std::vector<CurvePoint> points;
    std::vector<double> steps;
};

inline Sampled sampled(const Path& path, double from, double to, int n) {
    Sampled out;
    const double dv = (to - from) / n;
    for (int i = 0; i <= n; ++i) {
        out.points.push_back(path(from + dv * i));
        if (i == n) break;
        double length = 0;
        const double part = dv / 40, x = std::sqrt(0.6) / 2;
        for (int j = 0; j < 40; ++j) {
            const double middle = from + dv * i + part * (j + 0.5);
            length +=
                part / 18 *
                (5 * path(middle - x * part).d1.norm() + 8 * path(middle).d1.norm() +
                 5 * path(middle + x * part).d1.norm());
        }
        out.steps.push_back(length);
    }
    return out;
}

inline std::vector<HelixState<double>> states_of(std::span<const FrenetPoint> points) {
    std::vector<HelixState<double>> states;
    for (const FrenetPoint& p : points) states.push_back(p.state);
    return states;
}

inline FrenetProfile profile_of(const Sampled& x, FrenetMethod method) {
    const auto points = frenet_points(x.points, Vec3::UnitZ());
    return method == FrenetMethod::frames ? profile_of_frames(states_of(points), x.steps)
                                          : profile_of_points(points, x.steps);
}

/// The largest distance of the synthesized strand from the samples it came from.
inline double round_trip_error(const Sampled& x, FrenetMethod method) {
    const auto strand = synthesize(profile_of(x, method));
    double worst = 0;
    for (std::size_t i = 0; i < strand.size(); ++i) {
        worst = std::max(worst, (strand[i].position - x.points[i].position).norm());
    }
    return worst;
}

}  // namespace lancret
