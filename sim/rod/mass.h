#pragma once
// The mass matrix of a Super-Helix [Bergbom07, Eq. 4.42, corrected].

#include "sim/rod/energy.h"

namespace lancret {

/// M = rho S int J^T J ds at the curvatures q, dense, [3 segments, 3 segments], g cm^4:
/// the kinetic energy is q'^T M q' / 2. Symmetric and positive semi-definite; its
/// nullity is the number of straight segments, whose twist the segments beyond can undo.
Eigen::MatrixXd rod_mass(const HangingRod& rod, const Eigen::VectorXd& q);

}  // namespace lancret
