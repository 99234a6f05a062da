#pragma once

#include <cmath>

#include "render_test/scene/camera.h"

namespace lancret {

/// At z = 50 cm, towards the origin: at that distance a picture shows 40 cm.
inline Camera made_camera() {
    return look_at(Vec3f(0, 0, 50), Vec3f::Zero(), Vec3f::UnitY(), 2 * std::atan(0.4f),
                   1);
}

}  // namespace lancret
