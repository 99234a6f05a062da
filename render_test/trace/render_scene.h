#pragma once
// The input of a render: geometry, materials and lights.

#include <optional>
#include <span>

#include "render_test/light/lights.h"
#include "render_test/material/blade.h"
#include "render_test/material/hair_look.h"
#include "render_test/material/lambert.h"
#include "render_test/scene/embree_scene.h"

namespace lancret {

struct CheckView;

/// Everything that rays and light meet. Geometry, times and view must outlive it.
struct RenderScene {
    const HairScene* geometry = nullptr;
    std::span<const SceneTime> times = {};  ///< the times of `geometry`, needed only for
                                            ///< the motion layer; else empty
    HairLook hair{HairMaterial{}};
    /// Hair for every scattering after a path's first. Path regularisation: rougher hair
    /// there leaves less noise and is slightly brighter (docs/render_speed.md). Unset:
    /// `hair`.
    std::optional<HairLook> later_hair;
    MeshMaterial mesh;
    BladeMaterial blade;  ///< of ribbons
    Lights lights;
    const CheckView* view = nullptr;  ///< if set, its false colours replace light
};

}  // namespace lancret
