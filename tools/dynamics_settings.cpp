#include "tools/dynamics_settings.h"

#include <memory>
#include <utility>

#include "guides/bodies/moving_bodies.h"
#include "guides/mesh/closest_point.h"

namespace lancret {

namespace {

void read_material(const TomlTable& dynamics, SimulationSettings& out) {
    RodMaterial& hair = out.material;
    assign_if(hair.young_modulus, dynamics.number("young_modulus", 1e3, 1e15));
    assign_if(hair.poisson_ratio, dynamics.number("poisson_ratio", -0.99, 0.5));
    assign_if(hair.radius1, dynamics.number("radius", 1e-5, 10));
    hair.radius2 = hair.radius1;
    assign_if(hair.radius2, dynamics.number("radius2", 1e-5, 10));
    assign_if(hair.density, dynamics.number("density", 1e-3, 1e3));
    assign_if(out.dissipation, dynamics.choice("dissipation", kDissipationNames));
    assign_if(out.damping, dynamics.number("damping", 0, 1e6));
    assign_if(out.drag, dynamics.number("drag", 0, 1e3));
}

void read_contact(const TomlTable& contact, DynamicsSettings& out) {
    ContactSettings& c = out.simulation.contact;
    assign_if(out.collide_with_head, contact.boolean("head"));
    assign_if(c.thickness, contact.number("thickness", 0, 10));
    assign_if(c.stiffness, contact.number("stiffness", 1e-3, 1e9));
    assign_if(c.regularization, contact.number("regularization", 1e-6, 10));
    assign_if(c.friction, contact.number("friction", 0, 10));
    assign_if(c.free_root, contact.number("free_root", 0, 100));
    assign_if(c.stations, contact.integer("stations", 1, 16));
}

void read_strands(const TomlTable& strands, StrandContactSettings& out) {
    assign_if(out.radius, strands.number("radius", 0, 10));
    assign_if(out.stiffness, strands.number("stiffness", 0, 1e6));
    assign_if(out.friction_across, strands.number("friction_across", 0, 1e3));
    assign_if(out.friction_along, strands.number("friction_along", 0, 1e3));
    assign_if(out.cohesion, strands.number("cohesion", 0, 1e6));
}

void read_wind(const TomlTable& wind, WindSettings& out) {
    assign_if(out.mean, bounded_vector(wind, "velocity"));
    assign_if(out.turbulence, wind.number("turbulence", 0, 1e5));
    assign_if(out.length_scale, wind.number("length_scale", 0.1, 1e5));
    assign_if(out.time_scale, wind.number("time_scale", 1e-3, 1e5));
    assign_if(out.seed,
              wind.integer("seed", 0, std::numeric_limits<std::int64_t>::max()));
}

void read_step(const TomlTable& dynamics, SimulationSettings& out) {
    assign_if(out.step.integrator, dynamics.choice("integrator", kIntegratorNames));
    assign_if(out.substeps, dynamics.integer("substeps", 1, 1000));
    assign_if(out.adaptive, dynamics.boolean("adaptive"));
    assign_if(out.error_tolerance, dynamics.number("error_tolerance", 1e-6, 1e3));
    assign_if(out.sag_free, dynamics.boolean("sag_free"));
}

}  // namespace

DynamicsSettings read_dynamics(const TomlTable& toml, const SceneUnits& scene,
                               MotionSettings motion) {
    DynamicsSettings out;
    const TomlTable dynamics = toml.table("dynamics");
    out.simulation.gravity = scene.gravity;
    read_material(dynamics, out.simulation);
    read_step(dynamics, out.simulation);
    read_contact(dynamics.table("contact"), out);
    read_strands(dynamics.table("strands"), out.simulation.strand_contact);
    read_wind(dynamics.table("wind"), out.simulation.wind);
    out.motion = std::move(motion);
    out.colliders = read_colliders(toml, out.motion);
    return out;
}

SimulationScene simulation_scene(const DynamicsSettings& settings,
                                 const PlacedGuides& placed, const SceneUnits& scene,
                                 double frames_per_second) {
    const TriangleMesh* rest = placed.scalp ? &placed.scalp->mesh : nullptr;
    const auto head = std::make_shared<const ScalpMotion>(
        scalp_motion(settings.motion, rest, frames_per_second));
    const bool deforms = settings.motion.deforms();
    const TriangleMesh* body = placed.body && !deforms ? &*placed.body : rest;
    MovingBodies bodies = moving_bodies(
        {head, settings.collide_with_head ? body : nullptr, deforms}, settings.colliders,
        scene.centimetres_per_unit(), frames_per_second);
    SimulationScene out{scalp_motion(settings.motion, rest, frames_per_second),
                        {},
                        frames_per_second,
                        std::move(bodies.colliders),
                        std::move(bodies.move)};
    std::optional<ClosestPoint> closest;
    if (rest) closest.emplace(*rest);
    for (std::size_t g = 0; g < placed.guides.size(); ++g) {
        RestRoot root{placed.guides.root(g), {}};
        if (closest) root.point = closest->closest(root.pose.position).point;
        out.roots.push_back(root);
    }
    return out;
}

}  // namespace lancret
