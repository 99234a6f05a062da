#pragma once
// The scenes by which the renderer's speed is told: curly strands on a sphere under sun
// and sky.

#include <string>

#include "guides/mesh/triangle_mesh.h"
#include "procedural/curves/curves.h"
#include "render_test/scene/camera.h"
#include "render_test/trace/integrator.h"

namespace lancret::bench {

struct SphereScene {
    Curves curves;      ///< B-splines, flat
    TriangleMesh mesh;  ///< the sphere they stand on
    Camera camera;
    RenderScene scene;  ///< its geometry is for the caller to build
};

/// "A": 10,000 strands of 33 points, 0.3 pixel wide in a picture of 512 x 512; "B":
/// 100,000 of 17, 0.1 pixel wide. Strands are 7 cm on a sphere of 9 cm and curl twice.
/// Throws std::invalid_argument for any other name.
SphereScene sphere_scene(const std::string& name);

}  // namespace lancret::bench
