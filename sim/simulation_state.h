#pragma once
// The state of a Simulation and how it advances.

#include <oneapi/tbb/enumerable_thread_specific.h>

#include "guides/helix/guides.h"
#include "sim/contact/strand_contact.h"
#include "sim/simulation_settings.h"

namespace lancret {

/// The buffers of one thread.
struct SimulationWorker {
    RodStepper stepper;
    RodContact contact;
    std::vector<Vec3> curvatures, rates;  ///< before a step that may be rejected
    RodPast past;                         ///< likewise
    SimulationReport report;
};

struct SimulationState {
    SimulationSettings settings;
    SimulationScene scene;
    RodSection section;
    Wind wind;
    double frame = 0;
    Guides guides;
    std::vector<Vec3> natural, rates;
    std::vector<RootMotion> roots, next_roots;
    std::vector<RodPast> pasts;
    std::vector<int> halvings;  ///< [guides], of a substep, as last taken
    std::vector<ContactAnchor> anchors;
    std::vector<double> allowed_depths;  ///< [guides * stations], cm
    std::vector<int> allowed_bodies;     ///< [guides * stations], -1: none
    std::vector<Clearance> clearances;   ///< [guides * stations], a cache: results do
                                         ///< not depend on it
    StrandNeighbours neighbours;
    tbb::enumerable_thread_specific<SimulationWorker> workers;
    Guides initial;
    double initial_frame = 0;

    /// Throws as the constructor of Simulation does.
    SimulationState(const Guides& rest, SimulationSettings s, SimulationScene sc,
                    double at_frame);

    /// Stations per guide.
    std::size_t stations() const {
        return std::size_t(guides.segments * settings.contact.stations);
    }
    bool strands_touch() const { return settings.strand_contact.radius > 0; }
    std::span<Vec3> curvatures_of(std::size_t g) {
        return std::span(guides.curvatures)
            .subspan(g * std::size_t(guides.segments), std::size_t(guides.segments));
    }
    Rod rod(std::size_t g) const {
        const auto n = std::size_t(guides.segments);
        return {guides.lengths_of(g), std::span(natural).subspan(g * n, n), section};
    }

    /// Puts roots and bodies where they are at a frame and forgets all motion.
    void start_at(double at_frame);
    /// Advances all guides to `frame`, which is `eps` seconds ahead.
    void substep(double to_frame, double eps);

  private:
    struct GuideStep;

    void find_roots(double at_frame, std::vector<RootMotion>& out) const;
    void measure_initial_depths();
    RodContact::Strand contact_strand(std::size_t g, const Rod& rod);
    void advance_guide(std::size_t g, double eps, double time, double drift,
                       SimulationWorker& worker);
    bool try_part(const GuideStep& part, SimulationWorker& worker, StepReport& report);
    void finish_part(const GuideStep& part, const StepReport& report,
                     SimulationWorker& worker);
};

}  // namespace lancret
