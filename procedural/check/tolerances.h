#pragma once
// What passes.

namespace lancret {

/// What a strand may be off by before the check fails.
struct CheckTolerances {
    double orthogonality = 1e-6;   ///< of any entry of R^T R - I
    double length = 1e-5;          ///< relative, of the strand as synthesised
    double emitted_length = 1e-2;  ///< relative, of the curve through the control points
    double distance = 0.03;        ///< cm, of that curve from the strand
    double root = 1e-3;            ///< cm, of the curve's start from the root
};

}  // namespace lancret
