#pragma once
// Curves through keys that never overshoot them.

#include <span>
#include <vector>

namespace lancret {

/// A number and its first two derivatives in the parameter.
struct CubicValue {
    double value = 0, slope = 0, bend = 0;
};

/// The slopes at the keys (x_i, y_i), x strictly increasing, of the monotone cubic
/// through them (Fritsch and Carlson 1980): three-point slopes, none where the secants
/// change sign, drawn in to the circle of radius 3 in which a piece is monotone. The
/// first and the last are 0, so that a curve held before and after its keys is C1.
std::vector<double> monotone_slopes(std::span<const double> x, std::span<const double> y);

/// The cubic of values y0, y1 and slopes m0, m1 at x0 < x1, at x.
CubicValue hermite_cubic(double x0, double x1, double y0, double y1, double m0, double m1,
                         double x);

}  // namespace lancret
