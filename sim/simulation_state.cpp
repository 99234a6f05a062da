#include "sim/simulation_state.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "guides/base/errors.h"
#include "guides/helix/super_helix.h"
#include "sim/equilibrium/sag_free.h"
#include "sim/segment/gauss_legendre.h"

namespace lancret {

namespace {

/// The motion at the fraction `share` of the way from a to b, at constant velocity.
RootMotion between(const RootMotion& a, const RootMotion& b, double share) {
    if (share >= 1) return b;
    const Vec3 turn = rotation_log<double>(b.pose.frame * a.pose.frame.transpose());
    const auto mix = [&](const Vec3& x, const Vec3& y) { return x + share * (y - x); };
    RootMotion out;
    out.pose.frame = helix_step<double>(turn, share).rotation * a.pose.frame;
    orthonormalize<double>(out.pose.frame);
    out.pose.position = mix(a.pose.position, b.pose.position);
    out.velocity = mix(a.velocity, b.velocity);
    out.angular_velocity = mix(a.angular_velocity, b.angular_velocity);
    out.acceleration = mix(a.acceleration, b.acceleration);
    out.angular_acceleration = mix(a.angular_acceleration, b.angular_acceleration);
    return out;
}

/// Written so that a number that is not finite fails too.
bool within(double x, double low, double high = 1e15) { return x >= low && x <= high; }

void validate(const SimulationSettings& s) {
    require(within(s.gravity.cwiseAbs().maxCoeff(), 0) && s.gravity.allFinite(),
            "Simulation: gravity must be finite");
    require(within(s.drag, 0), "Simulation: drag must be at least 0");
    require(s.substeps >= 1 && s.substeps <= 1000,
            "Simulation: expected 1 to 1000 substeps");
    require(s.max_halvings >= 0 && s.max_halvings <= 20,
            "Simulation: expected 0 to 20 halvings");
    require(s.error_tolerance > 0, "Simulation: the error tolerance must be above 0");
    require(s.step.tolerance > 0 && s.step.max_iterations >= 1,
            "Simulation: expected a step tolerance above 0 and at least one iteration");
    const ContactSettings& c = s.contact;
    require(c.stations >= 1 && c.stations <= kMaxGaussPoints,
            "Simulation: expected 1 to 32 stations");
    require(within(c.stiffness, 1e-15) && within(c.regularization, 1e-15) &&
                within(c.friction, 0) && within(c.thickness, 0) && within(c.free_root, 0),
            "Simulation: contact settings must be finite, stiffness and regularization "
            "above 0, the others at least 0");
    const StrandContactSettings& h = s.strand_contact;
    for (const double x :
         {h.radius, h.stiffness, h.friction_across, h.friction_along, h.cohesion}) {
        require(within(x, 0),
                "Simulation: strand contact settings must be finite and at least 0");
    }
}

void validate(const Guides& rest) {
    require(rest.size() > 0 && rest.segments > 0,
            "Simulation: expected at least one guide with at least one segment");
    const std::size_t all = rest.size() * std::size_t(rest.segments);
    require(rest.root_frames.size() == rest.size() &&
                rest.segment_lengths.size() == all && rest.curvatures.size() == all,
            "Simulation: expected one frame per guide, and one length and curvature per "
            "segment");
    for (const double l : rest.segment_lengths) {
        require(within(l, 1e-15), "Simulation: segment lengths must be above 0");
    }
    for (const Vec3& k : rest.curvatures) {
        require(k.allFinite(), "Simulation: curvatures must be finite");
    }
}

}  // namespace

SimulationState::SimulationState(const Guides& rest, SimulationSettings s,
                                 SimulationScene sc, double at_frame)
    : settings(std::move(s)),
      scene(std::move(sc)),
      section(rod_section(settings.material, settings.dissipation, settings.damping)),
      wind(make_wind(settings.wind)),
      guides(rest),
      workers([this] {
          return SimulationWorker{
              {}, RodContact(scene.colliders, settings.contact, settings.strand_contact),
              {}, {},
              {}, {}};
      }) {
    validate(guides);
    validate(settings);
    require(scene.roots.size() == guides.size(),
            "Simulation: expected one root per guide");
    require(within(scene.frames_per_second, 1e-6),
            "Simulation: frames_per_second must be above 0");
    require(within(std::abs(at_frame), 0, 1e9),
            "Simulation: the frame must be within 1e9");
    rates.assign(guides.curvatures.size(), Vec3::Zero());
    pasts.resize(guides.size());
    halvings.assign(guides.size(), 0);
    anchors.resize(guides.size() * stations());
    allowed_depths.assign(anchors.size(), 0);
    allowed_bodies.assign(anchors.size(), -1);
    clearances.resize(anchors.size());
    roots.resize(guides.size());
    next_roots.resize(guides.size());
    start_at(at_frame);
    natural = settings.sag_free ? sag_free_natural(guides, section, settings.gravity)
                                : guides.curvatures;
    measure_initial_depths();
    initial = guides;
    initial_frame = at_frame;
}

void SimulationState::find_roots(double at_frame, std::vector<RootMotion>& out) const {
    const ScalpTime time = scalp_at(scene.motion, at_frame);
    for (std::size_t g = 0; g < out.size(); ++g) {
        out[g] = root_motion(time, scene.roots[g]);
    }
}

void SimulationState::start_at(double at_frame) {
    frame = at_frame;
    find_roots(at_frame, roots);
    for (std::size_t g = 0; g < guides.size(); ++g) {
        guides.root_positions[g] = roots[g].pose.position;
        guides.root_frames[g] = roots[g].pose.frame;
        pasts[g].size = 0;
    }
    if (scene.move_colliders) scene.move_colliders(at_frame, scene.colliders);
    std::ranges::fill(rates, Vec3::Zero());
    std::ranges::fill(halvings, 0);
    std::ranges::fill(anchors, ContactAnchor{});
    std::ranges::fill(clearances, Clearance{});
}

/// Measures how deep the groom itself lies in bodies: contact allows it that depth.
void SimulationState::measure_initial_depths() {
    if (scene.colliders.size() == 0) return;
    const double thickness = settings.contact.thickness;
    const GaussRule rule = gauss_rule(settings.contact.stations);
    tbb::parallel_for(std::size_t(0), guides.size(), [&](std::size_t g) {
        std::vector<double> s;
        double start = 0;
        for (const double l : guides.lengths_of(g)) {
            for (const double node : rule.nodes) s.push_back(start + node * l);
            start += l;
        }
        sample(super_helix(guides, g), s, [&](std::size_t i, auto, const auto& state) {
            const SurfaceSample body =
                scene.colliders.nearest(state.position, contact_reach(settings.contact));
            if (s[i] < settings.contact.free_root || body.distance >= thickness) return;
            allowed_depths[g * stations() + i] = thickness - body.distance;
            allowed_bodies[g * stations() + i] = body.collider;
        });
    });
}

RodContact::Strand SimulationState::contact_strand(std::size_t g, const Rod& rod) {
    const std::size_t n = stations();
    RodContact::Strand strand;
    strand.lengths = rod.lengths;
    strand.anchors = std::span(anchors).subspan(g * n, n);
    strand.allowed_depths = std::span(allowed_depths).subspan(g * n, n);
    strand.allowed_bodies = std::span(allowed_bodies).subspan(g * n, n);
    strand.clearances = std::span(clearances).subspan(g * n, n);
    if (strands_touch()) {
        strand.positions = neighbours.positions(g);
        strand.near = neighbours.near(g);
        strand.near_counts = neighbours.counts(g);
    }
    return strand;
}

/// One step of one guide over a part of a substep.
struct SimulationState::GuideStep {
    std::size_t guide = 0;
    Rod rod;
    RodForces forces;
    RodContact::Strand strand;
    bool contact = false;  ///< whether anything can touch the guide
    std::span<Vec3> curvatures, rates;
    double eps = 0;       ///< s, of the whole substep
    double end = 0;       ///< share of the substep at which the part ends
    double duration = 0;  ///< s, of the part
    RootMotion from, to;
};

/// Takes a step over `part`. If it fails or its error is too large, returns false; the
/// state from before the step is then in `worker`.
bool SimulationState::try_part(const GuideStep& part, SimulationWorker& worker,
                               StepReport& report) {
    worker.curvatures.assign(part.curvatures.begin(), part.curvatures.end());
    worker.rates.assign(part.rates.begin(), part.rates.end());
    worker.past = pasts[part.guide];
    if (part.contact) worker.contact.begin(part.strand, part.eps, part.end);
    report = worker.stepper.step(part.rod, part.forces, settings.step,
                                 {part.from, part.to.pose, part.duration, part.curvatures,
                                  part.rates, pasts[part.guide]},
                                 part.contact ? &worker.contact : nullptr);
    return report.solved && std::isfinite(report.local_error) &&
           report.local_error <= settings.error_tolerance;
}

/// Accepts the step over `part`, whether or not it succeeded.
void SimulationState::finish_part(const GuideStep& part, const StepReport& report,
                                  SimulationWorker& worker) {
    ++worker.report.steps;
    worker.report.iterations += std::size_t(report.iterations);
    worker.report.unconverged += !report.converged;
    if (report.solved) {
        worker.report.largest_error =
            std::max(worker.report.largest_error, report.local_error);
        if (part.contact) {
            worker.report.deepest = std::max(worker.report.deepest,
                                             worker.contact.end(worker.stepper.system()));
        }
    } else {
        ++worker.report.unsolved;
        std::ranges::fill(part.rates, Vec3::Zero());
        pasts[part.guide].size = 0;
    }
}

void SimulationState::advance_guide(std::size_t g, double eps, double time, double drift,
                                    SimulationWorker& worker) {
    GuideStep part;
    part.guide = g;
    part.rod = rod(g);
    part.strand = contact_strand(g, part.rod);
    for (Clearance& c : part.strand.clearances) c.distance -= drift;
    part.contact = scene.colliders.size() > 0 || strands_touch();
    part.curvatures = curvatures_of(g);
    const std::size_t segments = part.curvatures.size();
    part.rates = std::span(rates).subspan(g * segments, segments);
    part.eps = eps;
    part.from = roots[g];
    double now = 0;  // s, at the end of the current part
    part.forces = {settings.gravity, settings.drag, {}};
    if (settings.wind.mean != Vec3::Zero() || !wind.waves.empty()) {
        part.forces.wind = [this, &now](const Vec3& x) {
            return wind_velocity(wind, x, now);
        };
    }

    // Progress is counted in the smallest parts that the substep can be divided into.
    const int max_level = settings.adaptive ? settings.max_halvings : 0;
    const int count = 1 << max_level;
    int& level = halvings[g];
    level = std::min(level, max_level);
    double carried = 0;  // share of the substep over which the anchors were carried
    for (int done = 0; done < count;) {
        const int size = count >> level;
        part.duration = eps / (1 << level);
        part.end = double(done + size) / count;
        part.to = between(roots[g], next_roots[g], part.end);
        now = time - (1 - part.end) * eps;
        carry(scene.colliders, part.strand.anchors, carried, part.end);
        carried = part.end;
        StepReport report;
        if (!try_part(part, worker, report) && level < max_level) {
            std::ranges::copy(worker.curvatures, part.curvatures.begin());
            std::ranges::copy(worker.rates, part.rates.begin());
            std::swap(worker.past, pasts[g]);
            ++level;
            continue;
        }
        finish_part(part, report, worker);
        done += size;
        part.from = part.to;
        // The error grows as the square of the step: a doubled step has four times it.
        if (level > 0 && report.local_error < settings.error_tolerance / 8 &&
            done % (2 * size) == 0) {
            --level;
        }
    }
    guides.root_positions[g] = next_roots[g].pose.position;
    guides.root_frames[g] = next_roots[g].pose.frame;
}

void SimulationState::substep(double to_frame, double eps) {
    if (strands_touch()) {
        neighbours.find(guides, pasts, settings.strand_contact.radius,
                        settings.contact.stations, eps);
    }
    find_roots(to_frame, next_roots);
    if (scene.move_colliders) scene.move_colliders(to_frame, scene.colliders);
    const double drift = scene.colliders.drift();
    tbb::parallel_for(std::size_t(0), guides.size(), [&](std::size_t g) {
        advance_guide(g, eps, to_frame / scene.frames_per_second, drift, workers.local());
    });
    std::swap(roots, next_roots);
    frame = to_frame;
}

}  // namespace lancret
