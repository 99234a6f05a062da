#include "sim/contact/contact.h"

#include <algorithm>
#include <cmath>

#include "sim/segment/gauss_legendre.h"

namespace lancret {

namespace {

/// The spring to an anchor, limited by Coulomb friction: the Huber function of the slide.
struct Friction {
    double energy = 0, stiffness = 0;  ///< stiffness: force / slide
    bool slips = false;
};

Friction friction(double slide, double stiffness, double limit) {
    if (stiffness * slide <= limit) {
        return {stiffness * slide * slide / 2, stiffness, false};
    }
    return {limit * (slide - limit / stiffness / 2), limit / slide, true};
}

}  // namespace

Penalty penalty(double depth, double stiffness, double regularization) {
    const double k = stiffness, d = depth, reg = regularization;
    if (d <= 0) return {0, 0, 0};
    if (d <= reg) return {k * d * d * d / (6 * reg), k * d * d / (2 * reg), k * d / reg};
    return {k * (d * d / 2 - d * reg / 2 + reg * reg / 6), k * (d - reg / 2), k};
}

void carry(const Colliders& colliders, std::span<ContactAnchor> anchors, double from,
           double to) {
    for (ContactAnchor& anchor : anchors) {
        if (!anchor.touches()) continue;
        anchor.position = colliders.carried(anchor.body, anchor.position, from, to);
    }
}

RodContact::RodContact(const Colliders& colliders, const ContactSettings& settings,
                       const StrandContactSettings& strands)
    : colliders_(colliders), settings_(settings), strands_(strands) {}

void RodContact::begin(const Strand& strand, double eps, double share) {
    strand_ = strand;
    eps_ = share * eps;
    share_ = share;
    // Clearances hold only for the bodies' current pose. If distances can jump, as around
    // the borders of an open mesh, they are dropped at each step, so that results never
    // depend on the history.
    remembers_ = share == 1;
    const bool lent = !strand.clearances.empty();
    own_clearances_.assign(lent ? 0 : strand.anchors.size(), {});
    if (!lent) strand_.clearances = own_clearances_;
    reference_ = colliders_.reference();
    if (!colliders_.closed()) std::ranges::fill(strand_.clearances, Clearance{});
}

SurfaceSample RodContact::sample(std::size_t station, const Vec3& position) {
    const double reach = contact_reach(settings_);
    if (!remembers_) return colliders_.nearest(position, reach, share_);
    Clearance& clear = strand_.clearances[station];
    const Vec3 local = inverse_image(reference_, position);
    if (clear.distance > 0 &&
        (local - clear.position).squaredNorm() < clear.distance * clear.distance) {
        return {};
    }
    const SurfaceSample nearest = colliders_.nearest(position, reach);
    // Slightly less, so that round-off never hides a contact.
    clear = {local, std::min(nearest.distance, reach) - settings_.thickness - 1e-9};
    return nearest;
}

double RodContact::allowance(std::size_t station, const SurfaceSample& body) const {
    const bool other = !strand_.allowed_bodies.empty() &&
                       strand_.allowed_bodies[station] != body.collider;
    return other ? 0 : strand_.allowed_depths[station];
}

double RodContact::strand_energy(RodSystem& system, const RodSystem::Point& point,
                                 std::size_t station, double weight, double scale) const {
    double energy = 0;
    for (int i = 0; i < strand_.near_counts[station]; ++i) {
        const StrandNear& other = strand_.near[station * kMaxNear + std::size_t(i)];
        const Vec3 away =
            point.position - (other.position - (1 - share_) * other.displacement);
        const double distance = away.norm(), w = weight * other.share;
        const double reach = 2 * strands_.radius;
        if (distance < 1e-9) continue;  // no direction to push in
        const Vec3 normal = away / distance;
        const Penalty push = penalty(reach - distance, strands_.stiffness, reach / 4);
        Vec3 force = w * push.force * normal;
        Mat3 stiffness = w * push.stiffness * normal * normal.transpose();
        energy += w * push.energy;
        if (strands_.cohesion > 0 && distance > reach && distance < 2 * reach) {
            // A well between one and two reaches: one period of a cosine, so that the
            // pull is continuous. Negative curvature is left out of the stiffness.
            const double x = (distance - reach) / reach, turn = 2 * kPi * x;
            const double depth = strands_.cohesion * reach / (2 * kPi);
            energy += w * depth * (x * 2 * kPi - std::sin(turn)) / (2 * kPi);
            const double pull = depth / reach * (1 - std::cos(turn));
            force -= w * pull * normal;
            const double bend = depth / (reach * reach) * 2 * kPi * std::sin(turn);
            stiffness += w * std::max(bend, 0.) * normal * normal.transpose();
        } else if (strands_.cohesion > 0 && distance >= 2 * reach) {
            energy += w * strands_.cohesion * reach / (2 * kPi);  // out of the well
        }
        // Viscous friction relative to the other strand's motion. It fades with the
        // distance at the start of the step, so that it is constant within the step.
        const double start_distance =
            (strand_.positions[station] - (other.position - other.displacement)).norm();
        const double near = std::clamp(2 - start_distance / reach, 0., 1.);
        const Vec3 t = other.tangent;
        const Mat3 drag =
            near * w / eps_ *
            (strands_.friction_across * Mat3::Identity() +
             (strands_.friction_along - strands_.friction_across) * t * t.transpose());
        const Vec3 slide =
            point.position - strand_.positions[station] - share_ * other.displacement;
        energy += slide.dot(drag * slide) / 2;
        force -= drag * slide;
        stiffness += drag;
        system.add(point, scale * stiffness, scale * force);
    }
    return energy;
}

double RodContact::add_to(RodSystem& system, double scale) {
    const int stations = settings_.stations;
    const GaussRule rule = gauss_rule(stations);
    double energy = 0, start = 0;
    for (int q = 0; q < system.segments(); ++q) {
        const double length = strand_.lengths[q];
        for (int i = 0; i < stations; ++i) {
            const std::size_t station = std::size_t(q * stations + i);
            const double u = length * rule.nodes[i], weight = length * rule.weights[i];
            const bool other =
                !strand_.near_counts.empty() && strand_.near_counts[station] > 0;
            const bool free = start + u < settings_.free_root || colliders_.size() == 0;
            if (free && !other) continue;
            const RodSystem::Point point = system.point(q, u);
            if (other) {
                energy += strand_energy(system, point, station, weight, scale);
            }
            if (free) continue;
            const SurfaceSample body = sample(station, point.position);
            const double depth =
                settings_.thickness - allowance(station, body) - body.distance;
            if (!(depth > 0)) continue;
            const Penalty push =
                penalty(depth, settings_.stiffness, settings_.regularization);
            const Vec3& n = body.normal;
            energy += weight * push.energy;
            Vec3 force = weight * push.force * n;
            Mat3 stiffness = weight * push.stiffness * n * n.transpose();
            const ContactAnchor& anchor = strand_.anchors[station];
            if (anchor.touches() && settings_.friction > 0) {
                const Vec3 away = point.position - anchor.position;
                const Vec3 slide = away - n * n.dot(away);
                const Friction held = friction(slide.norm(), settings_.stiffness,
                                               settings_.friction * anchor.pressure);
                energy += weight * held.energy;
                force -= weight * held.stiffness * slide;
                Mat3 across = Mat3::Identity() - n * n.transpose();
                if (held.slips) {
                    // The pull on a slipping station can only change its direction.
                    across -= slide * slide.transpose() / slide.squaredNorm();
                }
                stiffness += weight * held.stiffness * across;
            }
            system.add(point, scale * stiffness, scale * force);
        }
        start += length;
    }
    return scale * energy;
}

double RodContact::end(const RodSystem& system) {
    const GaussRule rule = gauss_rule(settings_.stations);
    double deepest = 0, start = 0;
    for (int q = 0; q < system.segments(); ++q) {
        const double length = strand_.lengths[q];
        for (int i = 0; i < settings_.stations; ++i) {
            const std::size_t station = std::size_t(q * settings_.stations + i);
            const double u = length * rule.nodes[i];
            ContactAnchor& anchor = strand_.anchors[station];
            const bool free = start + u < settings_.free_root || colliders_.size() == 0;
            const Vec3 position = free ? Vec3::Zero() : system.point(q, u).position;
            const SurfaceSample body = free ? SurfaceSample{} : sample(station, position);
            const double allowed = allowance(station, body);
            const double depth = settings_.thickness - allowed - body.distance;
            if (!(depth > 0)) {
                anchor = {};
                continue;
            }
            deepest = std::max(
                deepest, -body.distance - std::max(0., allowed - settings_.thickness));
            const double pressure =
                penalty(depth, settings_.stiffness, settings_.regularization).force;
            if (!anchor.touches() || anchor.body.collider != body.collider) {
                anchor.position = position;
            }
            const Vec3 away = position - anchor.position;
            const Vec3 slide = away - body.normal * body.normal.dot(away);
            const double max_slide = settings_.friction * pressure / settings_.stiffness;
            const double length_of_slide = slide.norm();
            // The anchor lies at the depth of the station, no further away than friction
            // can hold.
            anchor.position =
                position - (length_of_slide > max_slide
                                ? Vec3(slide * (max_slide / length_of_slide))
                                : slide);
            anchor.body = body;
            anchor.pressure = pressure;
        }
        start += length;
    }
    return deepest;
}

}  // namespace lancret
