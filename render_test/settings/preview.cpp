#include "render_test/settings/preview.h"

#include <fmt/format.h>

#include <limits>

#include "render_test/settings/light.h"
#include "render_test/settings/material.h"
#include "render_test/settings/toml_values.h"

namespace lancret {

namespace {

void read_render(const TomlTable& render, PreviewSettings& out) {
    assign_if(out.render.width, render.integer("width", 1, 16384));
    assign_if(out.render.height, render.integer("height", 1, 16384));
    const auto samples = render.integer("samples", 1, 65536);
    assign_if(out.render.samples, samples);
    out.samples_given = samples.has_value();
    assign_if(out.render.noise, render.number("noise", 0, 10));
    if (out.render.noise > 0 && !samples) out.render.samples = kMaxAdaptiveSamples;
    assign_if(out.render.seed,
              render.integer("seed", 0, std::numeric_limits<std::int64_t>::max()));
    assign_if(out.render.path.max_depth, render.integer("max_depth", 1, 10000));
    assign_if(out.regularisation, render.number("regularisation", 0, 1));
    assign_if(out.render.path.lobes, render.choice("lobes", kLobeWidthNames));
    assign_if(out.background, colour_value(render, "background", 1e6));
    assign_if(out.min_width, render.number("min_width_pixels", 0, 10));
    out.shutter = render.pair("shutter");
    if (out.shutter && !is_shutter(*out.shutter)) {
        render.fail(
            "shutter",
            "'shutter' must be [opens, closes] in frames after the frame, such as "
            "[0, 0.5], within 1000 and not closed before it opens");
    }
    assign_if(out.motion_samples,
              render.integer("motion_samples", 2, std::int64_t(kMaxSceneTimes)));
}

void read_surfaces(const TomlTable& material, PreviewSettings& out) {
    assign_if(out.blade.translucency, material.number("translucency", 0, 1));
    assign_if(out.blade.coat_roughness, material.number("blade_roughness", 0.05, 1));
    assign_if(out.crease, angle_value(material, "scalp_crease_degrees", 0, 180));
}

}  // namespace

std::optional<HairLook> later_hair(const PreviewSettings& settings) {
    if (!(settings.regularisation > 0)) return std::nullopt;
    return HairLook(settings.hair, settings.regularisation);
}

bool is_shutter(const Vec2& shutter) {
    // Written so that NaN is refused.
    return shutter.cwiseAbs().maxCoeff() <= 1000 && shutter.x() <= shutter.y();
}

PreviewSettings read_preview_settings(const TomlTable& toml, const Vec3f& up) {
    PreviewSettings out;
    out.render.path.lobes = LobeWidth::automatic;
    read_material(toml.table("material"), out.hair, out.mesh,
                  out.render.path.groom_shading);
    read_surfaces(toml.table("material"), out);
    out.camera = read_camera(toml.table("camera"));
    out.lights = read_lights(toml.table("light"), up);
    read_render(toml.table("render"), out);
    return out;
}

Camera preview_camera(const PreviewSettings& settings, const Eigen::AlignedBox3f& box,
                      const Vec3f& up) {
    const float aspect = float(settings.render.width) / float(settings.render.height);
    return camera_of(settings.camera, box, up, aspect);
}

}  // namespace lancret
