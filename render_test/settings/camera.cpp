#include "render_test/settings/camera.h"

#include <algorithm>
#include <stdexcept>

#include "guides/base/coordinates.h"
#include "render_test/settings/toml_values.h"

namespace lancret {
namespace {

/// The camera's matrix for column vectors, from `matrix` (USD: camera to world) or
/// `world_to_camera` (OpenEXR: left-handed, z into the picture). Files contain either for
/// row vectors.
std::optional<Eigen::Matrix4d> read_matrix(const TomlTable& camera, float field_of_view) {
    const auto usd = camera.matrix("matrix"), exr = camera.matrix("world_to_camera");
    if (!usd && !exr) return std::nullopt;
    const char* key = usd ? "matrix" : "world_to_camera";
    for (const char* other :
         {"position", "target", "view", "margin", "world_to_camera"}) {
        if (key != std::string_view(other) && camera.has(other)) {
            camera.fail(other, "a camera with a matrix cannot have another position");
        }
    }
    Eigen::Matrix4d to_world = usd ? usd->transpose() : exr->transpose();
    if (exr) {
        to_world = to_world.inverse().eval();
        to_world.col(2) *= -1;
    }
    try {
        const Camera made = camera_of_matrix(to_world, field_of_view, 1);
        if (!is_place(made.position)) {
            throw std::invalid_argument("the camera is too far away");
        }
    } catch (const std::invalid_argument& error) {
        camera.fail(key, error.what());
    }
    return to_world;
}

}  // namespace

CameraSettings read_camera(const TomlTable& camera) {
    CameraSettings out;
    assign_if(out.field_of_view, angle_value(camera, "field_of_view_degrees", 1, 150));
    out.position = place_value(camera, "position");
    out.target = place_value(camera, "target");
    out.view = direction_value(camera, "view");
    if (out.position && out.view) {
        camera.fail("view", "a camera can have a 'position' or a 'view', not both");
    }
    if (out.target && !out.position) {
        camera.fail("target", "'target' needs a 'position'");
    }
    if (out.position && out.target == out.position) {
        camera.fail("target", "'target' must not be the camera's 'position'");
    }
    assign_if(out.margin, camera.number("margin", 0.1, 100));
    out.to_world = read_matrix(camera, out.field_of_view);
    assign_if(out.f_stop, camera.number("f_stop", 0.1, 1000));
    assign_if(out.focus_distance, camera.number("focus_distance", 1e-3, 1e9));
    if (out.focus_distance && !out.f_stop) {
        camera.fail("focus_distance", "'focus_distance' needs an 'f_stop'");
    }
    return out;
}

Camera camera_of(const CameraSettings& settings, const Eigen::AlignedBox3f& box,
                 const Vec3f& up, float aspect) {
    Camera camera;
    if (settings.to_world) {
        camera = camera_of_matrix(*settings.to_world, settings.field_of_view, aspect);
        const float depth =
            box.isEmpty() ? 0 : (box.center() - camera.position).dot(camera.view());
        camera.focus_distance = std::max(depth, 1e-3f);
    } else if (settings.position) {
        const Vec3f target = settings.target.value_or(box.center());
        camera = look_at(*settings.position, target, up, settings.field_of_view, aspect);
    } else {
        Framing framing;
        framing.up = up;
        framing.field_of_view = settings.field_of_view;
        framing.aspect = aspect;
        framing.margin = settings.margin;
        // Default: the front of a head that looks along +Z (Y up) or -Y (Z up).
        const Vec3f front = up.z() > 0.5f ? Vec3f(0, -1, 0) : Vec3f(0, 0, 1);
        const Vec3f side = up.cross(front);
        framing.view = settings.view.value_or(Vec3f(-front - 0.45f * side - 0.12f * up));
        camera = framed(box, framing);
    }
    if (settings.f_stop) {
        camera.lens_radius = lens_radius_of(*settings.f_stop, settings.field_of_view);
    }
    if (settings.focus_distance) camera.focus_distance = *settings.focus_distance;
    return camera;
}

}  // namespace lancret
