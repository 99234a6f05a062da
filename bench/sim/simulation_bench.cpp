// Guides in real time: a shaking head with 400 made guides, at 24 frames per second and
// 4 substeps per frame.

#include <benchmark/benchmark.h>

#include "guides/fit/super_helix_fit.h"
#include "guides/made/made_groom.h"
#include "sim/simulation.h"

namespace lancret {
namespace {

Simulation shaken_head(bool contact) {
    MadeGroomSettings settings;
    settings.strands = 400;
    const MadeGroom groom = make_groom(settings);
    std::vector<std::uint32_t> all(groom.strands.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = std::uint32_t(i);
    const Guides guides = fit_guides(groom.strands, all, {}, {}).guides;
    std::vector<PoseKey> shakes(4);
    for (int i = 0; i < 4; ++i) {
        shakes[std::size_t(i)].frame = 1 + 8 * i;
        shakes[std::size_t(i)].rotation.y() = i % 2 ? 40 : -40;
    }
    SimulationScene scene{make_rigid_path(shakes, Vec3::Zero(), 24), {}, 24, {}, {}};
    for (std::size_t g = 0; g < guides.size(); ++g) {
        scene.roots.push_back({guides.root(g), {}});
    }
    if (contact) {
        scene.colliders.add(groom.head);
        const RigidPath path = std::get<RigidPath>(scene.motion);
        scene.move_colliders = [path](double frame, Colliders& colliders) {
            colliders.move(0, rigid_motion(path, frame).pose);
        };
    }
    return Simulation(guides, {}, std::move(scene), 1);
}

void frame_of_400_guides(benchmark::State& state, bool contact) {
    Simulation simulation = shaken_head(contact);
    std::size_t steps = 0;
    for (auto _ : state) {
        if (simulation.frame() >= 25) simulation.reset();
        simulation.advance();
        steps += simulation.take_report().steps;
    }
    // Above 1 the guides keep up with 24 frames a second.
    state.counters["times_real_time"] =
        benchmark::Counter(1. / 24, benchmark::Counter::kIsIterationInvariantRate);
    state.counters["guide_steps"] =
        benchmark::Counter(double(steps), benchmark::Counter::kAvgIterations);
}
BENCHMARK_CAPTURE(frame_of_400_guides, free, false)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(frame_of_400_guides, head_contact, true)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace lancret
