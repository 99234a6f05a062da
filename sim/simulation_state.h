#pragma once
// What a Simulation holds, and how it moves on. Only simulation*.cpp include it.

#include <oneapi/tbb/enumerable_thread_specific.h>

#include "sim/contact/strand_contact.h"
#include "sim/simulation.h"

namespace lancret {

/// What a thread works with.
struct SimulationWorker {
    RodStepper stepper;
    RodContact contact;
    std::vector<Vec3> curvatures, rates;  ///< before a step that may be refused
    RodPast past;
    SimulationReport report;
};

struct Simulation::State {
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
    std::vector<double> allowed;
    std::vector<int> allowed_bodies;  ///< of each station, -1 where none
    std::vector<Clearance> clear;     ///< of each station; what it says is never needed
    StrandNeighbours neighbours;
    tbb::enumerable_thread_specific<SimulationWorker> workers;
    Guides initial;
    double initial_frame = 0;

    State(const Guides& rest, SimulationSettings s, SimulationScene sc, double at);

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
    void move_roots(double to, std::vector<RootMotion>& out) const;
    void stand(double at);
    void measure_groom();
    void substep(double to, double eps);
    void advance_guide(std::size_t g, double eps, double time, double drift,
                       SimulationWorker& worker);
};

}  // namespace lancret
