#pragma once
// Curves through keys that never overshoot them.

#include <span>
#include <vector>

namespace lancret {

/// A value and its first two derivatives with respect to the parameter.
struct CubicValue {
    double value = 0, slope = 0, bend = 0;
};

/// The slopes at the keys (x_i, y_i), x strictly increasing, of the monotone cubic
/// through them (Fritsch and Carlson 1980): three-point slopes, 0 where the secants
/// change sign, reduced to the circle of radius 3 in which a piece is monotone. The first
/// and the last are 0, so that a curve that is constant beyond its keys is C1.
std::vector<double> monotone_slopes(std::span<const double> x, std::span<const double> y);

/// The cubic with values y0, y1 and slopes m0, m1 at x0 < x1, evaluated at x.
CubicValue hermite_cubic(double x0, double x1, double y0, double y1, double m0, double m1,
                         double x);

}  // namespace lancret
