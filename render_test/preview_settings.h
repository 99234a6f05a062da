#pragma once
// What a groom's file says of its picture.

#include <optional>

#include "procedural/toml_table.h"
#include "render_test/camera.h"
#include "render_test/render.h"

namespace lancret {

struct PreviewSettings {
    HairMaterial hair;
    MeshMaterial mesh;
    RenderSettings render;
    float regularisation = 0.5f;  ///< roughness of hair after a path's first scattering,
                                  ///< at least; 0: as the material is
    std::optional<Vec3f> camera_position;  ///< cm; none: the camera frames the groom
    std::optional<Vec3f> camera_target;    ///< cm; none: the middle of the groom
    std::optional<Vec3f> view;  ///< direction of sight; none: from the front, a little
                                ///< to the side and above
    float field_of_view = 0.5236f;  ///< vertical, radian (30 degrees)
    float margin = 1.15f;
    std::optional<Lights> lights;  ///< none: the default rig
    std::optional<Vec2> shutter;   ///< frames after the frame, opens <= closes; none: the
                                   ///< frame as it is, without motion blur
    int motion_samples = 3;        ///< times in the shutter, 2 to kMostSceneTimes
    Vec3f background = Vec3f::Constant(0.18f);  ///< linear, behind a PNG
};

/// What RenderScene's later_hair is by these settings.
std::optional<HairModel> later_hair(const PreviewSettings& settings);

/// Whether a shutter may be: within a thousand frames, and not closed before it opens.
bool is_shutter(const Vec2& shutter);

/// Reads the tables [camera], [material], [light] and [render]; `up` is the scene's.
/// Throws InputError, also for a texture or environment that cannot be read.
PreviewSettings read_preview_settings(const TomlTable& toml, const Vec3f& up);

/// The camera for something in `box` (cm).
Camera preview_camera(const PreviewSettings& settings, const Eigen::AlignedBox3f& box,
                      const Vec3f& up);

}  // namespace lancret
