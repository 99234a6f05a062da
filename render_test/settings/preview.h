#pragma once
// The picture settings of a groom file.

#include <optional>

#include "guides/toml/table.h"
#include "render_test/settings/camera.h"
#include "render_test/trace/render.h"

namespace lancret {

struct PreviewSettings {
    HairMaterial hair;
    MeshMaterial mesh;
    BladeMaterial blade;
    float crease = 1.05f;  ///< of HairSceneOptions, radian
    RenderSettings render;
    bool samples_given = false;  ///< whether the file sets render.samples
    CameraSettings camera;
    float min_width = 0;           ///< minimum drawn width of a strand, pixels
    float regularisation = 0.5f;   ///< minimum roughness of hair after a path's first
                                   ///< scattering; 0: that of the material
    std::optional<Lights> lights;  ///< unset: default_lights()
    std::optional<Vec2> shutter;   ///< frames after the frame, opens <= closes; unset: no
                                   ///< motion blur
    int motion_samples = 3;        ///< times within the shutter, 2 to kMaxSceneTimes
    bool denoise = false;          ///< the finished picture (denoise.h)
    Vec3f background = Vec3f::Constant(0.18f);  ///< linear, behind a PNG
};

/// RenderScene::later_hair for these settings.
std::optional<HairLook> later_hair(const PreviewSettings& settings);

/// Whether a shutter is valid: within a thousand frames, and not closed before it opens.
bool is_shutter(const Vec2& shutter);

/// Reads the tables [camera], [material], [light] and [render]; `up` is that of the
/// scene. Throws InputError, also if a texture or environment cannot be read.
PreviewSettings read_preview_settings(const TomlTable& toml, const Vec3f& up);

/// The camera for a subject in `box` (cm).
Camera preview_camera(const PreviewSettings& settings, const Eigen::AlignedBox3f& box,
                      const Vec3f& up);

}  // namespace lancret
