#pragma once
// The equilibrium shape of a hanging rod.

#include "sim/rod/energy.h"

namespace lancret {

struct RodEquilibrium {
    Eigen::VectorXd q;               ///< [3 segments], 1/cm
    HangingEnergy energy;            ///< erg
    double smallest_eigenvalue = 1;  ///< of D^-1 H, D = K l: 1 without weight
    int snaps = 0;                   ///< number of folds at which the shape jumped
    bool left_branch = false;        ///< not the continuation of the natural shape
    bool converged = false;
    bool stable = false;  ///< converged, and a minimum except for neutral directions
};

enum class Branch {
    leave,  ///< if it is not a minimum
    keep,   ///< whether or not it is stable
};

/// The equilibrium reached as the weight grows from 0. With Branch::leave, if that is not
/// a minimum of the energy, the minimum reached by leaving it (in the direction of
/// rod_minimum). If the branch ends in a fold, the rod descends to another branch, within
/// its plane of symmetry if it has one. Throws as validate_rod does. Always terminates;
/// if it finds no answer, `converged` is false.
RodEquilibrium rod_equilibrium(const HangingRod& rod, Branch branch = Branch::leave);

}  // namespace lancret
