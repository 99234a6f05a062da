#pragma once
// Settings, scene and report of a Simulation.

#include <functional>
#include <vector>

#include "guides/motion/scalp_motion.h"
#include "sim/contact/contact.h"
#include "sim/rod/step.h"
#include "sim/wind.h"

namespace lancret {

/// Incremented whenever results change for the same settings.
inline constexpr int kSimulationMethod = 1;

struct SimulationSettings {
    RodMaterial material;
    Dissipation dissipation = Dissipation::viscoelastic;
    double damping = 0.05;     ///< mu, s, or gamma, dyn cm^2 s
    Vec3 gravity{0, -981, 0};  ///< cm/s^2
    double drag = 2e-4;        ///< nu, g/(cm s)
    WindSettings wind;
    ContactSettings contact;
    StrandContactSettings strand_contact;
    /// Friction converges slowly when much of a strand slips at once. A step that stops
    /// iterating too early leaves the strand stuck, and the forces on it then pull it
    /// into bodies.
    StepSettings step{.max_iterations = 60};
    int substeps = 4;              ///< per frame, the same for all guides
    bool adaptive = true;          ///< a guide may divide a substep further
    double error_tolerance = 0.5;  ///< cm, of a step's local error at each joint
    int max_halvings = 4;          ///< of a substep
    bool sag_free = true;          ///< the groom is at rest under gravity
};

/// The motion of the scalp and the bodies around the guides.
struct SimulationScene {
    ScalpMotion motion;
    std::vector<RestRoot> roots;  ///< [guides], at rest
    double frames_per_second = 24;
    Colliders colliders;  ///< at the first frame
    /// Moves each body to its pose at a frame; empty if the bodies stand still.
    std::function<void(double frame, Colliders&)> move_colliders;
};

/// Statistics of a number of steps.
struct SimulationReport {
    std::size_t steps = 0;        ///< each of one guide
    std::size_t iterations = 0;   ///< of Gauss-Newton
    std::size_t unconverged = 0;  ///< steps that ended above the tolerance
    std::size_t unsolved = 0;     ///< steps that failed; the guide followed its root
    double deepest = 0;           ///< cm, of a station in a body, beyond the groom's own
    double largest_error = 0;     ///< cm, local error of an accepted step
};

/// Adds `from` to `to`: sums counts and takes the larger of each maximum.
void add(SimulationReport& to, const SimulationReport& from);

}  // namespace lancret
