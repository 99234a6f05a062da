#pragma once
// A rod let go from its natural shape.

#include <functional>

#include "sim/rod/energy.h"
#include "sim/rod/step.h"

namespace lancret {

/// Iterations until nothing more is gained: a turn left over is an error of energy.
StepSettings to_round_off(Integrator integrator);

struct ReleaseSettings {
    double duration = 1;  ///< s, > 0
    double step = 1e-3;   ///< s, > 0; made a little shorter where it does not divide
    StepSettings stepping = to_round_off(Integrator::bdf2);
    std::size_t max_samples = 1000;  ///< of the energy, at least 2
    int shapes = 9;                  ///< kept, at equal times, the first and last too
};

struct ReleaseSample {
    double time = 0;                  ///< s
    double kinetic = 0, elastic = 0;  ///< erg
    double weight = 0;                ///< erg, 0 with all mass at the root

    double total() const { return kinetic + elastic + weight; }
};

struct RodRelease {
    std::vector<ReleaseSample> samples;   ///< the first and the last moment among them
    std::vector<Eigen::VectorXd> shapes;  ///< curvatures q, the first and last among them
    Eigen::VectorXd q;                    ///< at the end
    double largest_change = 0;            ///< of |E - E0| at any step, erg
    double largest_rise = 0;              ///< of E from a step to the next, erg, or 0
    std::size_t steps = 0, unconverged = 0;
    /// False where a step failed: all ends there, as what the semi-implicit step does
    /// where it diverges.
    bool finished = false;
};

/// Steps of a rod that at time 0 is in its natural shape, at rest, and feels all its
/// weight; velocities are told by differences of places. `progress` is given the share
/// done, in [0, 1], now and then. Throws std::invalid_argument as check_rod does, and
/// where settings make no sense: a time that is not finite and above 0, more than 10^8
/// steps, fewer than two samples or shapes.
RodRelease release_rod(const HangingRod& rod, const ReleaseSettings& settings,
                       const std::function<void(double)>& progress = {});

}  // namespace lancret
