#pragma once
// The shape in which a rod hangs.

#include "sim/rod/energy.h"

namespace lancret {

struct RodEquilibrium {
    Eigen::VectorXd q;               ///< [3 segments], 1/cm
    HangingEnergy energy;            ///< erg
    double smallest_eigenvalue = 1;  ///< of D^-1 H, D = K l: 1 without weight
    int snaps = 0;                   ///< how often the branch ended on the way
    bool left_branch = false;        ///< it does not continue the natural shape
    bool converged = false;
    bool stable = false;  ///< converged, and a minimum but for neutral directions
};

enum class Branch {
    leave,  ///< where it is no minimum
    keep,   ///< stable or not
};

/// The equilibrium reached as the weight grows from none, and where that is no minimum of
/// the energy, the minimum reached by leaving it (rod_minimum says which way). Where the
/// branch ends in a fold on the way, the rod goes downhill to another, in its plane if it
/// has one. Throws std::invalid_argument as check_rod does; ends always, and where it
/// ends without an answer, not `converged`.
RodEquilibrium rod_equilibrium(const HangingRod& rod, Branch branch = Branch::leave);

}  // namespace lancret
