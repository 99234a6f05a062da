#pragma once
// The dynamics of a groom: the tables [dynamics] and [[colliders]] of its TOML.
// docs/formats.md lists their keys.

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

/// Reads [dynamics] and [[colliders]]. `motion` is the head's, from [motion].
DynamicsSettings read_dynamics(const TomlTable& toml, const SceneUnits& scene,
                               MotionSettings motion);

/// What the guides of a groom move with. Throws InputError.
SimulationScene simulation_scene(const DynamicsSettings& settings,
                                 const PlacedGuides& placed, const SceneUnits& scene,
                                 double frames_per_second);

}  // namespace lancret
