#pragma once
// Many guides over time: roots that follow a scalp, bodies, wind, and contact between
// strands.

#include <memory>
#include <span>
#include <vector>

#include "guides/files/guide_cache_restart.h"
#include "guides/helix/guides.h"
#include "sim/simulation_settings.h"

namespace lancret {

struct SimulationState;

/// A simulation at one time. Deterministic: the same bits for any number of threads.
class Simulation {
  public:
    /// `rest` are the groom's guides at rest, in the rest pose of the scalp. The
    /// simulation starts with them at `frame`, with no motion except that of the scalp.
    /// Throws std::invalid_argument if sizes or settings are invalid, InputError if the
    /// scalp's motion is.
    Simulation(const Guides& rest, SimulationSettings settings, SimulationScene scene,
               double frame);
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    double frame() const;
    const Guides& guides() const;               ///< at the current frame
    std::span<const Vec3> natural() const;      ///< curvatures without load, 1/cm
    std::span<const Vec3> rates() const;        ///< q', 1/(cm s)
    std::span<const RootMotion> roots() const;  ///< at the current frame

    /// Number of guides with a station within a body's contact thickness at the start.
    /// Contact allows them the depth that they start with.
    std::size_t guides_in_bodies() const;
    const RodSection& section() const;

    /// Advances by one frame. Does not allocate once the buffers are warm, unless the
    /// head deforms: its mesh is then read and its tree rebuilt.
    void advance();
    /// The report of all steps since the last call.
    SimulationReport take_report();

    /// Makes the current shapes the natural ones: without load the guides would keep
    /// them [Bergbom07, Sec. 5.3.2].
    void set_natural();
    /// Makes the current guides, at rest, and the current frame the ones that reset()
    /// returns to.
    void set_initial();
    /// Returns to the initial state and frame: those of the constructor unless
    /// set_initial() was called.
    void reset();

    /// Everything except guides() that resume() needs, natural curvatures included.
    RestartArrays restart() const;
    /// Continues from `frame`. Throws std::invalid_argument if the arrays are not those
    /// of a simulation of the same size.
    void resume(double frame, const Guides& guides, const RestartArrays& arrays);

  private:
    std::unique_ptr<SimulationState> state_;
};

/// Simulates frames `first` to `last` and returns the guides at each of them, both ends
/// included.
std::vector<Guides> simulate(const Guides& rest, const SimulationSettings& settings,
                             SimulationScene scene, int first, int last);

}  // namespace lancret
