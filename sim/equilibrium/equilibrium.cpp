#include "sim/equilibrium/equilibrium.h"

#include <limits>

#include "sim/equilibrium/minimum.h"
#include "sim/equilibrium/walk.h"

namespace lancret {

RodEquilibrium rod_equilibrium(const HangingRod& rod, Branch which) {
    RodEquilibrium out;
    RodBranch branch(rod);
    const double any = std::numeric_limits<double>::infinity();
    out.converged = walk_branch(branch, rod, 1, any, [&](WalkEvent event) {
        if (event == WalkEvent::fold) ++out.snaps;
        return true;
    });
    out.q = branch.q();
    out.smallest_eigenvalue = branch.smallest_eigenvalue();
    const double neutral = neutral_eigenvalue(rod);
    if (which == Branch::leave &&
        !(out.converged && out.smallest_eigenvalue > -neutral)) {
        const RodMinimum minimum = rod_minimum(rod, out.q);
        out.q = minimum.q;
        out.smallest_eigenvalue = minimum.smallest_eigenvalue;
        out.left_branch = true;
        out.converged = minimum.converged;
    }
    out.left_branch = out.left_branch || out.snaps > 0;
    out.energy = rod_energy(rod, out.q);
    out.stable = out.converged && out.smallest_eigenvalue > -neutral;
    return out;
}

}  // namespace lancret
