#pragma once
// What a groom's file says of its picture.

#include <optional>

#include "guides/toml/table.h"
#include "render_test/settings/camera.h"
#include "render_test/trace/render.h"

namespace lancret {

struct PreviewSettings {
    HairMaterial hair;
    MeshMaterial mesh;
    BladeMaterial blade;
    float crease = 1.05f;  ///< radian: HairSceneOptions'
    RenderSettings render;
    bool samples_given = false;  ///< whether render.samples was asked for
    CameraSettings camera;
    float least_width = 0;         ///< pixels that a strand is drawn wide at least
    float regularisation = 0.5f;   ///< roughness of hair after a path's first scattering,
                                   ///< at least; 0: as the material is
    std::optional<Lights> lights;  ///< none: the default rig
    std::optional<Vec2> shutter;   ///< frames after the frame, opens <= closes; none: the
                                   ///< frame as it is, without motion blur
    int motion_samples = 3;        ///< times in the shutter, 2 to kMaxSceneTimes
    bool denoise = false;          ///< a finished picture (denoise.h)
    Vec3f background = Vec3f::Constant(0.18f);  ///< linear, behind a PNG
};

/// What RenderScene's later_hair is by these settings.
std::optional<HairLook> later_hair(const PreviewSettings& settings);

/// Whether a shutter may be: within a thousand frames, and not closed before it opens.
bool is_shutter(const Vec2& shutter);

/// Reads the tables [camera], [material], [light] and [render]; `up` is the scene's.
/// Throws InputError, also for a texture or environment that cannot be read.
PreviewSettings read_preview_settings(const TomlTable& toml, const Vec3f& up);

/// The camera for something in `box` (cm).
Camera preview_camera(const PreviewSettings& settings, const Eigen::AlignedBox3f& box,
                      const Vec3f& up);

}  // namespace lancret
