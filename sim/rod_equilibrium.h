#pragma once
// The shape in which a rod hangs.

#include <optional>

#include "sim/rod_energy.h"

namespace lancret {

struct RodEquilibrium {
    Eigen::VectorXd q;               ///< [3 segments], 1/cm
    RodEnergy energy;                ///< erg
    double smallest_eigenvalue = 1;  ///< of D^-1 H, D = K l: 1 without weight
    bool left_branch = false;  ///< it is not the one that continues the natural shape
    bool converged = false;
    bool stable = false;  ///< converged, and a minimum but for neutral directions
};

/// The equilibrium reached as the weight grows from none, and where that is no minimum of
/// the energy, the minimum reached by leaving it (rod_minimum says which way). Where the
/// branch ends in a fold, so that the rod would snap, it goes downhill and on from there.
/// Throws std::invalid_argument as check_rod does; ends always.
RodEquilibrium rod_equilibrium(const HangingRod& rod);

/// The equilibrium that continues the natural shape, stable or not; none where the branch
/// ends before the full weight.
std::optional<RodEquilibrium> rod_branch_equilibrium(const HangingRod& rod);

/// The smallest factor on rod.gravity, up to `most`, at which the branch from the natural
/// shape stops being stable: the Hessian is singular there, to 1e-9 of the factor (1e-6
/// where the branch itself ends). None where there is no such factor. Two changes within
/// 10 % of the weight may pass for none.
std::optional<double> critical_weight(const HangingRod& rod, double most);

}  // namespace lancret
