#pragma once
// The table [camera] of a groom.

#include <optional>

#include "guides/toml/table.h"
#include "render_test/scene/camera.h"

namespace lancret {

/// A camera set by a matrix or a position, or framed automatically.
struct CameraSettings {
    std::optional<Eigen::Matrix4d> to_world;  ///< for column vectors; x right, y up, z
                                              ///< back; cm
    std::optional<Vec3f> position;            ///< cm; unset: the camera frames the groom
    std::optional<Vec3f> target;              ///< cm; unset: the middle of the groom
    std::optional<Vec3f> view;  ///< viewing direction; unset: from the front, slightly
                                ///< from the side and above
    float field_of_view = 0.5236f;  ///< vertical, radian (30 degrees)
    float margin = 1.15f;
    std::optional<float> f_stop;          ///< unset: a pinhole
    std::optional<float> focus_distance;  ///< cm along the viewing direction; unset: that
                                          ///< of the target or the middle of the groom
};

/// Throws InputError.
CameraSettings read_camera(const TomlTable& camera);

/// The camera for a subject in `box` (cm); `up` is that of the scene.
Camera camera_of(const CameraSettings& settings, const Eigen::AlignedBox3f& box,
                 const Vec3f& up, float aspect);

}  // namespace lancret
