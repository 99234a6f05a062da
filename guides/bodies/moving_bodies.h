#pragma once
// The bodies that strands collide with, and their motion.

#include <functional>
#include <memory>
#include <vector>

#include "guides/bodies/collider_settings.h"
#include "guides/bodies/colliders.h"
#include "guides/motion/scalp_motion.h"

namespace lancret {

/// The head as a body.
struct HeadBody {
    std::shared_ptr<const ScalpMotion> motion;
    const TriangleMesh* mesh = nullptr;  ///< at rest, cm; null: nothing collides with it
    bool deforms = false;  ///< `mesh` is the scalp that `motion` is a sequence of
};

struct MovingBodies {
    Colliders colliders;  ///< at rest
    /// Moves the bodies to their poses at a frame. May outlive this and the HeadBody.
    std::function<void(double frame, Colliders&)> move;
};

/// The head, if it has a mesh, and the bodies of `settings`, in this order. Reads the
/// OBJ files of the bodies, scaled by `centimetres_per_unit`. Throws InputError.
MovingBodies moving_bodies(const HeadBody& head,
                           const std::vector<ColliderSettings>& settings,
                           double centimetres_per_unit, double frames_per_second);

}  // namespace lancret
