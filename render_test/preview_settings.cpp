#include "render_test/preview_settings.h"

#include <fmt/format.h>

#include <numbers>

#include "guides/coordinates.h"

namespace lancret {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

template <class T, class U>
void set(T& to, const std::optional<U>& value) {
    if (value) to = T(*value);
}

std::optional<Vec3f> single(const std::optional<Vec3>& v) {
    if (!v) return std::nullopt;
    return v->cast<float>();
}

/// A colour: three numbers, none negative, none above `most`.
std::optional<Vec3f> colour(const TomlTable& table, std::string_view key, double most) {
    const auto v = table.vector(key);
    if (v && !(v->minCoeff() >= 0 && v->maxCoeff() <= most)) {
        table.fail(
            key, fmt::format("'{}' is a colour: three numbers from 0 to {}", key, most));
    }
    return single(v);
}

/// A direction: three numbers, not all zero; of length one.
std::optional<Vec3f> direction(const TomlTable& table, std::string_view key) {
    const auto v = table.vector(key);
    if (!v) return std::nullopt;
    if (v->stableNorm() < 1e-12) {
        table.fail(key, fmt::format("'{}' is a direction and must not be zero", key));
    }
    return Vec3f(v->stableNormalized().cast<float>());
}

/// A place, cm.
std::optional<Vec3f> place(const TomlTable& table, std::string_view key) {
    const auto v = single(table.vector(key));
    if (v && !is_place(*v)) {
        table.fail(key, fmt::format("'{}' is a place and must lie within {:.0e} cm", key,
                                    kLargestCoordinate));
    }
    return v;
}

void read_material(const TomlTable& material, PreviewSettings& out) {
    set(out.hair.eumelanin, material.number("eumelanin", 0, 100));
    set(out.hair.pheomelanin, material.number("pheomelanin", 0, 100));
    if (const auto value = colour(material, "colour", 1)) out.hair.colour = value;
    set(out.hair.beta_m, material.number("roughness", 0.01, 1));
    set(out.hair.beta_n, material.number("azimuthal_roughness", 0.01, 1));
    if (const auto tilt = material.number("tilt_degrees", -20, 20)) {
        out.hair.tilt = float(*tilt * kDegree);
    }
    set(out.hair.eta, material.number("eta", 1.01, 5));
    set(out.mesh.colour, colour(material, "scalp_colour", 1));
    if (const auto file = material.path("scalp_texture")) {
        out.mesh.texture = read_colour_map(*file);
    }
}

void read_camera(const TomlTable& camera, PreviewSettings& out) {
    out.camera_position = place(camera, "position");
    out.camera_target = place(camera, "target");
    out.view = direction(camera, "view");
    if (out.camera_position && out.view) {
        camera.fail("view", "a camera has a 'position' or a 'view', not both");
    }
    if (out.camera_target && !out.camera_position) {
        camera.fail("target", "a 'target' needs a camera's 'position'");
    }
    if (out.camera_position && out.camera_target == out.camera_position) {
        camera.fail("target", "'target' must not be the camera's 'position'");
    }
    if (const auto angle = camera.number("field_of_view_degrees", 1, 150)) {
        out.field_of_view = float(*angle * kDegree);
    }
    set(out.margin, camera.number("margin", 0.1, 100));
}

void read_light(const TomlTable& light, const Vec3f& up, PreviewSettings& out) {
    const auto sky = colour(light, "sky", 1e6);
    const auto file = light.path("environment");
    const auto rotation = light.number("rotation_degrees", -360, 360);
    const float strength = float(light.number("strength", 0, 1e6).value_or(1));
    const auto sun = direction(light, "key_direction");
    const auto irradiance = colour(light, "key", 1e6);
    const auto radius = light.number("key_radius_degrees", 0.03, 80);
    if (sky && file)
        light.fail("sky", "light comes from a 'sky' or an 'environment', not both");
    if (rotation && !file)
        light.fail("rotation_degrees",
                   "'rotation_degrees' turns an 'environment'; name one");
    if (radius && !sun && !irradiance) {
        light.fail(
            "key_radius_degrees",
            "'key_radius_degrees' belongs to a 'key' or 'key_direction'; name one");
    }
    if (!sky && !file && !sun && !irradiance) {
        if (light.has("strength")) {
            light.fail("strength",
                       "'strength' is that of a 'sky', 'environment' or 'key'; name one");
        }
        return;
    }
    Environment environment(Vec3f(strength * sky.value_or(Vec3f::Constant(0.4f))));
    if (file) {
        ColourMap map = read_colour_map(*file);
        for (Vec3f& texel : map.texels) texel *= strength;
        environment =
            Environment(std::move(map), up, float(rotation.value_or(0) * kDegree));
    }
    std::vector<DistantLight> distant;
    if (sun || irradiance) {
        DistantLight key;
        set(key.direction, sun);
        key.irradiance = strength * irradiance.value_or(Vec3f::Constant(2));
        if (radius) key.angular_radius = float(*radius * kDegree);
        distant.push_back(key);
    }
    out.lights = Lights(std::move(environment), distant);
}

void read_render(const TomlTable& render, PreviewSettings& out) {
    set(out.render.width, render.integer("width", 1, 16384));
    set(out.render.height, render.integer("height", 1, 16384));
    set(out.render.samples, render.integer("samples", 1, 65536));
    set(out.render.seed,
        render.integer("seed", 0, std::numeric_limits<std::int64_t>::max()));
    set(out.render.path.max_depth, render.integer("max_depth", 1, 10000));
    set(out.regularisation, render.number("regularisation", 0, 1));
    set(out.background, colour(render, "background", 1e6));
    out.shutter = render.pair("shutter");
    if (out.shutter && !is_shutter(*out.shutter)) {
        render.fail("shutter",
                    "'shutter' is [opens, closes] in frames after the frame, such as [0, "
                    "0.5], within 1000 and not closed before it opens");
    }
    set(out.motion_samples,
        render.integer("motion_samples", 2, std::int64_t(kMostSceneTimes)));
}

}  // namespace

std::optional<HairModel> later_hair(const PreviewSettings& settings) {
    if (!(settings.regularisation > 0)) return std::nullopt;
    return HairModel(widened(settings.hair, settings.regularisation));
}

bool is_shutter(const Vec2& shutter) {
    // Written so that a NaN is none.
    return shutter.cwiseAbs().maxCoeff() <= 1000 && shutter.x() <= shutter.y();
}

PreviewSettings read_preview_settings(const TomlTable& toml, const Vec3f& up) {
    PreviewSettings out;
    read_material(toml.table("material"), out);
    read_camera(toml.table("camera"), out);
    read_light(toml.table("light"), up, out);
    read_render(toml.table("render"), out);
    return out;
}

Camera preview_camera(const PreviewSettings& settings, const Eigen::AlignedBox3f& box,
                      const Vec3f& up) {
    const float aspect = float(settings.render.width) / float(settings.render.height);
    if (settings.camera_position) {
        const Vec3f target = settings.camera_target.value_or(box.center());
        return look_at(*settings.camera_position, target, up, settings.field_of_view,
                       aspect);
    }
    Framing framing;
    framing.up = up;
    framing.field_of_view = settings.field_of_view;
    framing.aspect = aspect;
    framing.margin = settings.margin;
    // By default from the front of a head that looks along +Z (Y up) or -Y (Z up).
    const Vec3f front = up.z() > 0.5f ? Vec3f(0, -1, 0) : Vec3f(0, 0, 1);
    const Vec3f side = up.cross(front);
    framing.view = settings.view.value_or(Vec3f(-front - 0.45f * side - 0.12f * up));
    return framed(box, framing);
}

}  // namespace lancret
