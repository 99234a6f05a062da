#pragma once
// The table [camera] of a groom.

#include <optional>

#include "guides/toml/table.h"
#include "render_test/scene/camera.h"

namespace lancret {

/// Where a picture is taken from: by a matrix, from a position, or framed by itself.
struct CameraSettings {
    std::optional<Eigen::Matrix4d> to_world;  ///< for column vectors; x right, y up, z
                                              ///< back; cm
    std::optional<Vec3f> position;            ///< cm; none: the camera frames the groom
    std::optional<Vec3f> target;              ///< cm; none: the middle of the groom
    std::optional<Vec3f> view;  ///< direction of sight; none: from the front, a little
                                ///< to the side and above
    float field_of_view = 0.5236f;  ///< vertical, radian (30 degrees)
    float margin = 1.15f;
    std::optional<float> f_stop;          ///< none: a pinhole
    std::optional<float> focus_distance;  ///< cm along the sight; none: the target, or
                                          ///< the middle of the groom
};

/// Throws InputError.
CameraSettings read_camera(const TomlTable& camera);

/// The camera for something in `box` (cm); `up` is the scene's.
Camera camera_of(const CameraSettings& settings, const Eigen::AlignedBox3f& box,
                 const Vec3f& up, float aspect);

}  // namespace lancret
