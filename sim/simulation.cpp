#include "sim/simulation.h"

#include <algorithm>

#include "guides/base/errors.h"
#include "sim/restart_arrays.h"
#include "sim/simulation_state.h"

namespace lancret {

Simulation::Simulation(const Guides& rest, SimulationSettings settings,
                       SimulationScene scene, double frame)
    : state_(std::make_unique<SimulationState>(rest, std::move(settings),
                                               std::move(scene), frame)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

double Simulation::frame() const { return state_->frame; }
const Guides& Simulation::guides() const { return state_->guides; }
std::span<const Vec3> Simulation::natural() const { return state_->natural; }
std::span<const Vec3> Simulation::rates() const { return state_->rates; }
std::span<const RootMotion> Simulation::roots() const { return state_->roots; }

const RodSection& Simulation::section() const { return state_->section; }

std::size_t Simulation::guides_in_bodies() const {
    const std::size_t n = state_->stations();
    std::size_t out = 0;
    for (std::size_t g = 0; g < state_->guides.size(); ++g) {
        const auto depths = std::span(state_->allowed_depths).subspan(g * n, n);
        out += std::ranges::any_of(depths, [](double depth) { return depth > 0; });
    }
    return out;
}

void Simulation::advance() {
    const double start = state_->frame;
    const int n = state_->settings.substeps;
    // One value for all steps: differences of frames would not be exactly equal.
    const double eps = 1 / (state_->scene.frames_per_second * n);
    for (int k = 0; k < n; ++k) state_->substep(start + double(k + 1) / n, eps);
}

SimulationReport Simulation::take_report() {
    SimulationReport out;
    for (SimulationWorker& worker : state_->workers) {
        add(out, worker.report);
        worker.report = {};
    }
    return out;
}

void Simulation::set_natural() { state_->natural = state_->guides.curvatures; }

void Simulation::set_initial() {
    state_->initial = state_->guides;
    state_->initial_frame = state_->frame;
}

void Simulation::reset() {
    state_->guides = state_->initial;
    state_->start_at(state_->initial_frame);
}

RestartArrays Simulation::restart() const {
    const SimulationState& s = *state_;
    RestartArrays out;
    auto& past = out["past"];
    auto& touching = out["anchors"];
    auto &natural = out["natural"], &rates = out["rates"];
    for (const Vec3& k : s.natural) write(k, natural);
    for (const Vec3& k : s.rates) write(k, rates);
    out["halvings"].assign(s.halvings.begin(), s.halvings.end());
    for (const RodPast& p : s.pasts) write(p, s.guides.segments, past);
    for (const ContactAnchor& a : s.anchors) write(a, touching);
    out["allowed"] = s.allowed_depths;
    return out;
}

void Simulation::resume(double frame, const Guides& guides, const RestartArrays& arrays) {
    SimulationState& s = *state_;
    require(
        guides.size() == s.guides.size() && guides.segments == s.guides.segments &&
            guides.segment_lengths == s.guides.segment_lengths,
        "Simulation: resume: expected guides of the same count, segments and lengths");
    s.guides = guides;
    s.start_at(frame);
    ArrayReader natural(arrays, "natural"), rates(arrays, "rates"), past(arrays, "past"),
        halvings(arrays, "halvings"), anchors(arrays, "anchors"),
        allowed(arrays, "allowed");
    for (Vec3& k : s.natural) k = natural.vector();
    for (Vec3& k : s.rates) k = rates.vector();
    for (int& level : s.halvings) level = halvings.whole(0, 20);
    for (RodPast& p : s.pasts) read(past, s.guides.segments, p);
    for (ContactAnchor& a : s.anchors) read(anchors, s.scene.colliders, a);
    for (double& depth : s.allowed_depths) {
        depth = allowed.number();
        require(depth >= 0, "Simulation: resume: allowed depths must be at least 0");
    }
    for (const ArrayReader* reader :
         {&natural, &rates, &past, &halvings, &anchors, &allowed}) {
        require(reader->done(), "Simulation: resume: an array is too long");
    }
}

std::vector<Guides> simulate(const Guides& rest, const SimulationSettings& settings,
                             SimulationScene scene, int first, int last) {
    require(first <= last, "Simulation: the last frame must not be before the first");
    Simulation simulation(rest, settings, std::move(scene), first);
    std::vector<Guides> out{simulation.guides()};
    for (int frame = first; frame < last; ++frame) {
        simulation.advance();
        out.push_back(simulation.guides());
    }
    return out;
}

}  // namespace lancret
