#pragma once

namespace lancret {

/// The largest errors with which a strand passes the check.
struct CheckTolerances {
    double orthogonality = 1e-6;   ///< of any entry of R^T R - I
    double length = 1e-5;          ///< relative, of the synthesised strand
    double emitted_length = 1e-2;  ///< relative, of the emitted curve
    double distance = 0.03;        ///< cm, of the emitted curve from the strand
    double root = 1e-3;  ///< cm, of the start of the emitted curve from the root
};

}  // namespace lancret
