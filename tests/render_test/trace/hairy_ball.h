#pragma once
// A hairy ball with a camera and lights, for tests of whole pictures.

#include "render_test/trace/render.h"
#include "tests/render_test/make_curves.h"

namespace lancret {

struct HairyBall {
    Curves curves;
    TriangleMesh mesh = sphere_mesh(32, 16);
    HairScene geometry{curves, &mesh};
    RenderScene scene;
    Camera camera = framed(geometry.bounds(), {});
    RenderSettings settings;

    HairyBall(int width, int height, int samples, std::uint32_t strands = 1500,
              float radius = 0.03f)
        : curves(hairy_sphere(strands, 8, radius)) {
        scene.geometry = &geometry;
        scene.lights = default_lights(camera.view(), Vec3f::UnitY());
        settings.width = width, settings.height = height, settings.samples = samples;
    }
    Image image(const ProgressFunction& progress = {}) const {
        return render(scene, camera, settings, progress);
    }
};

}  // namespace lancret
