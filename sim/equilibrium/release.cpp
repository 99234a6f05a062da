#include "sim/equilibrium/release.h"

#include <algorithm>
#include <cmath>

#include "guides/base/errors.h"

namespace lancret {

namespace {

std::size_t step_count(const ReleaseSettings& settings) {
    const double count = std::ceil(settings.duration / settings.step * (1 - 1e-12));
    require(settings.duration > 0 && settings.step > 0 && count <= 1e8 &&
                std::isfinite(settings.duration),
            "release_rod: duration and step must be above 0 and give at most 10^8 steps");
    require(settings.max_samples >= 2 && settings.shapes >= 2,
            "release_rod: expected at least two samples and two shapes");
    return std::max<std::size_t>(std::size_t(count), 1);
}

}  // namespace

StepSettings to_round_off(Integrator integrator) {
    StepSettings out;
    out.integrator = integrator;
    out.tolerance = 1e-11;
    out.max_iterations = 60;
    return out;
}

RodRelease release_rod(const HangingRod& hanging, const ReleaseSettings& settings,
                       const std::function<void(double)>& progress) {
    validate_rod(hanging);
    const std::size_t count = step_count(settings);
    const double eps = settings.duration / double(count);
    const Rod rod{hanging.lengths, hanging.natural, hanging.section};
    RodForces forces;
    forces.gravity = hanging.gravity;
    const RootMotion root{hanging.root};
    std::vector<Vec3> curvatures = hanging.natural;
    std::vector<Vec3> rates(curvatures.size(), Vec3::Zero());
    RodStepper stepper;
    RodPast past;

    RodRelease out;
    out.q = natural_curvatures(hanging);
    const auto sample = [&](std::size_t i, double kinetic) -> ReleaseSample {
        const HangingEnergy energy = rod_energy(hanging, out.q);
        return {eps * double(i), kinetic, energy.elastic, energy.gravity};
    };
    out.samples.push_back(sample(0, 0));
    out.shapes.push_back(out.q);
    const double first = out.samples.front().total();
    double before = first;
    const std::size_t stride =
        (count + settings.max_samples - 2) / (settings.max_samples - 1);
    for (std::size_t i = 1; i <= count; ++i) {
        const StepReport report =
            stepper.step(rod, forces, settings.stepping,
                         {root, hanging.root, eps, curvatures, rates, past});
        if (!report.solved) return out;
        for (std::size_t q = 0; q < curvatures.size(); ++q) {
            out.q.segment<3>(3 * q) = curvatures[q];
        }
        ++out.steps;
        out.unconverged += !report.converged;
        const ReleaseSample now = sample(i, report.kinetic);
        if (!std::isfinite(now.total())) return out;
        out.largest_change = std::max(out.largest_change, std::abs(now.total() - first));
        out.largest_rise = std::max(out.largest_rise, now.total() - before);
        before = now.total();
        if (i % stride == 0 || i == count) out.samples.push_back(now);
        const auto shapes_due = [&](std::size_t step) {
            return step * std::size_t(settings.shapes - 1) / count;
        };
        if (shapes_due(i) > shapes_due(i - 1)) out.shapes.push_back(out.q);
        if (progress && i % 64 == 0) progress(double(i) / double(count));
    }
    out.finished = true;
    return out;
}

}  // namespace lancret
