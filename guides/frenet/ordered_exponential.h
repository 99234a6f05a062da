#pragma once
// The ordered exponential of a profile and its integral: a strand's shape without its
// root [TW99, Sec. 3.1].

#include <vector>

#include "guides/frenet/frenet_serret.h"

namespace lancret {

/// U(s) and R(s) at the joints of a profile, in the paper's convention: F has T, N, B as
/// rows and F(s) = U(s) F(0) [TW99, Eq. 13]. With our columns that is frame(s) =
/// frame(0) U(s)^T.
struct OrderedExponential {
    std::vector<double> arc_lengths;  ///< [n + 1], s from the root, cm
    std::vector<Mat3> rotations;      ///< [n + 1], U(s), orthogonal [TW99, Eq. 14]
    std::vector<Mat3> integrals;  ///< [n + 1], R(s), the integral of U, cm [TW99, Eq. 15]
};

/// U and R of a profile, exact for its piecewise constant rates. Does not use the root.
OrderedExponential ordered_exponential(const FrenetProfile& profile);

/// The strand of that shape on `root`: x(s) = x(0) + e1 . R(s) . F(0) [TW99, Eq. 16,
/// corrected: x(0) is missing in print].
std::vector<HelixState<double>> placed(const OrderedExponential& shape,
                                       const HelixState<double>& root);

}  // namespace lancret
