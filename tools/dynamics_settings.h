#pragma once
// The tables [dynamics] and [[colliders]] of a groom's TOML. docs/formats.md lists their
// keys.

#include <vector>

#include "guides/bodies/collider_settings.h"
#include "guides/motion/motion_settings.h"
#include "guides/toml/table.h"
#include "procedural/groom/placed_guides.h"
#include "sim/simulation.h"

namespace lancret {

struct DynamicsSettings {
    SimulationSettings simulation;
    MotionSettings motion;
    bool collide_with_head = true;
    std::vector<ColliderSettings> colliders;
};

/// Reads [dynamics] and [[colliders]]. `motion` is that of the head, from [motion].
/// Throws InputError.
DynamicsSettings read_dynamics(const TomlTable& toml, const SceneUnits& scene,
                               MotionSettings motion);

/// The moving head, roots and bodies for the simulation of a groom's guides. Throws
/// InputError.
SimulationScene simulation_scene(const DynamicsSettings& settings,
                                 const PlacedGuides& placed, const SceneUnits& scene,
                                 double frames_per_second);

}  // namespace lancret
