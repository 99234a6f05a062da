#pragma once
// Many guides in time: roots that follow a scalp, bodies, wind, and each other.

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "guides/files/guide_cache.h"
#include "guides/motion/scalp_motion.h"
#include "sim/contact/contact.h"
#include "sim/rod/step.h"
#include "sim/wind.h"

namespace lancret {

/// Raised whenever the same settings come to give other frames.
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
    /// Friction converges slowly where much of a strand slips at once; a step that ends
    /// before that leaves the strand stuck, and what pulls at it draws it into bodies.
    StepSettings step{.most_iterations = 60};
    int substeps = 4;              ///< of a frame, common to all guides
    bool adaptive = true;          ///< a guide may divide a substep further
    double error_tolerance = 0.5;  ///< cm, of a step's local error at each joint
    int most_halvings = 4;         ///< of a substep
    bool sag_free = true;          ///< the groom is at rest under gravity
};

/// What guides move with.
struct SimulationScene {
    ScalpMotion motion;
    std::vector<RestRoot> roots;  ///< [guides], at rest
    double frames_per_second = 24;
    Colliders colliders;  ///< at the first frame
    /// Moves the bodies to where they are at a frame, each once; empty where they stand.
    std::function<void(double frame, Colliders&)> move_colliders;
};

/// What happened since it was last asked for.
struct SimulationReport {
    std::size_t steps = 0;        ///< of one guide each
    std::size_t iterations = 0;   ///< of Gauss-Newton
    std::size_t unconverged = 0;  ///< steps that ended above the tolerance
    std::size_t unsolved = 0;     ///< steps that failed; the guide followed its root
    double deepest = 0;           ///< cm, of a station in a body, beyond the groom's own
    double largest_error = 0;     ///< cm, local, of a step that was taken
};

/// Takes `from` into `to`: sums, and the largest of what is largest.
void add(SimulationReport& to, const SimulationReport& from);

/// A simulation at one time. Deterministic: the same bits for any number of threads.
class Simulation {
  public:
    /// `rest` are the groom's guides as they hang at rest, in the rest pose of the scalp;
    /// the simulation begins with them at `frame`, still but for the scalp's motion.
    /// Throws std::invalid_argument where sizes or settings make no sense, InputError
    /// where the scalp's motion does.
    Simulation(const Guides& rest, SimulationSettings settings, SimulationScene scene,
               double frame);
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    double frame() const;
    const Guides& guides() const;               ///< now
    std::span<const Vec3> natural() const;      ///< curvatures without load, 1/cm
    std::span<const Vec3> rates() const;        ///< q', 1/(cm s)
    std::span<const RootMotion> roots() const;  ///< now

    /// Guides that lie in a body at the start, by the thickness kept or deeper. They are
    /// let alone so far.
    std::size_t guides_in_bodies() const;
    const RodSection& section() const;

    /// Moves on by one frame. Allocates nothing once buffers are warm, but
    /// for a head that deforms: its mesh is read and its tree built anew.
    void advance();
    SimulationReport take_report();

    /// Takes the current shapes as natural: without load the guides would stay so
    /// [Bergbom07, Sec. 5.3.2].
    void set_natural();
    /// Takes the current state, at rest, as the one that reset() goes back to.
    void set_initial();
    /// Back to the initial state and its frame; at first the one it was made with.
    void reset();

    /// All that going on from here needs beside guides(), natural curvatures included.
    RestartArrays restart() const;
    /// Goes on from a frame. Throws std::invalid_argument where the arrays are not those
    /// of such a simulation.
    void resume(double frame, const Guides& guides, const RestartArrays& arrays);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The guides at frames first to last, inclusive, in one call.
std::vector<Guides> simulate(const Guides& rest, const SimulationSettings& settings,
                             SimulationScene scene, int first, int last);

}  // namespace lancret
