#pragma once
// A rod released from its natural shape.

#include <functional>

#include "sim/rod/energy.h"
#include "sim/rod/step.h"

namespace lancret {

/// Settings that iterate down to round-off, since a remaining turn is an error of energy.
StepSettings to_round_off(Integrator integrator);

struct ReleaseSettings {
    double duration = 1;  ///< s, > 0
    double step = 1e-3;   ///< s, > 0; shortened to divide the duration
    StepSettings stepping = to_round_off(Integrator::bdf2);
    std::size_t max_samples = 1000;  ///< of the energy, >= 2
    int shapes = 9;                  ///< stored, at equal intervals, both ends included
};

struct ReleaseSample {
    double time = 0;                  ///< s
    double kinetic = 0, elastic = 0;  ///< erg
    double weight = 0;                ///< erg, 0 if all mass is at the root

    double total() const { return kinetic + elastic + weight; }
};

struct RodRelease {
    std::vector<ReleaseSample> samples;   ///< including the first and the last time
    std::vector<Eigen::VectorXd> shapes;  ///< curvatures q, likewise
    Eigen::VectorXd q;                    ///< at the end
    double largest_change = 0;            ///< maximum of |E - E0| over all steps, erg
    double largest_rise = 0;  ///< largest increase of E in one step, erg, >= 0
    std::size_t steps = 0, unconverged = 0;
    /// False if a step failed, as when the semi-implicit step diverges; everything ends
    /// there.
    bool finished = false;
};

/// Simulates a rod that at time 0 is at rest in its natural shape and then feels its full
/// weight. Velocities are differences of positions. `progress` is called now and then
/// with the fraction done, in [0, 1]. Throws as validate_rod does, and
/// std::invalid_argument for a time that is not finite and above 0, more than 10^8 steps,
/// or fewer than two samples or shapes.
RodRelease release_rod(const HangingRod& rod, const ReleaseSettings& settings,
                       const std::function<void(double)>& progress = {});

}  // namespace lancret
