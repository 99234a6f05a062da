#include "guides/motion/monotone_cubic.h"

#include <cmath>

namespace lancret {

std::vector<double> monotone_slopes(std::span<const double> x,
                                    std::span<const double> y) {
    std::vector<double> slopes(x.size(), 0.0);
    const auto secant = [&](std::size_t i) {
        return (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
    };
    for (std::size_t i = 1; i + 1 < x.size(); ++i) {
        const double before = secant(i - 1), after = secant(i);
        if (!((before > 0 && after > 0) || (before < 0 && after < 0))) continue;
        const double share = (x[i] - x[i - 1]) / (x[i + 1] - x[i - 1]);
        slopes[i] = (1 - share) * before + share * after;
    }
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        const double d = secant(i);
        if (d == 0) continue;  // both slopes are 0
        const double size = std::hypot(slopes[i] / d, slopes[i + 1] / d);
        if (size <= 3) continue;
        slopes[i] *= 3 / size;
        slopes[i + 1] *= 3 / size;
    }
    return slopes;
}

CubicValue hermite_cubic(double x0, double x1, double y0, double y1, double m0, double m1,
                         double x) {
    // y = y0 + t h (m0 + t (a + t b)), t in [0, 1], with a and b from the far end.
    const double h = x1 - x0, t = (x - x0) / h, d = (y1 - y0) / h;
    const double a = 3 * d - 2 * m0 - m1, b = m0 + m1 - 2 * d;
    return {y0 + t * h * (m0 + t * (a + t * b)), m0 + t * (2 * a + 3 * t * b),
            (2 * a + 6 * t * b) / h};
}

}  // namespace lancret
