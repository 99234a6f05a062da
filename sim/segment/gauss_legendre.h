#pragma once
// Gauss-Legendre quadrature on [0, 1].

#include <span>

namespace lancret {

/// Largest number of points of a rule.
inline constexpr int kMaxGaussPoints = 32;

struct GaussRule {
    std::span<const double> nodes;    ///< ascending, in (0, 1)
    std::span<const double> weights;  ///< positive, sum 1
};

/// The rule of n points, 1 <= n <= kMaxGaussPoints: exact for degree 2n - 1.
GaussRule gauss_rule(int n);

/// Number of points for a segment that turns by `turn` = |k| l: 5 + turn, rounded up to a
/// multiple of four, from 8 to kMaxGaussPoints. The relative error of all segment
/// integrals is then below 1e-10 for turns up to 25.
int gauss_points(double turn);

}  // namespace lancret
