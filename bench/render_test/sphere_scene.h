#pragma once
// The scenes that measure the renderer's speed: curly strands on a sphere under sun and
// sky.

#include <string>

#include "guides/mesh/triangle_mesh.h"
#include "procedural/curves/curves.h"
#include "render_test/scene/camera.h"
#include "render_test/trace/integrator.h"

namespace lancret::bench {

struct SphereScene {
    Curves curves;      ///< B-splines, flat
    TriangleMesh mesh;  ///< the sphere under them
    Camera camera;
    RenderScene scene;  ///< without geometry, which the caller builds
};

/// "A": 10,000 strands of 33 points, 0.3 pixel wide in a picture of 512 x 512. "B":
/// 100,000 strands of 17 points, 0.1 pixel wide. Strands are 7 cm long, curl twice and
/// stand on a sphere of radius 9 cm. Throws std::invalid_argument for any other name.
SphereScene sphere_scene(const std::string& name);

}  // namespace lancret::bench
