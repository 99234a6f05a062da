#include "render_test/settings/light.h"

#include "render_test/files/read_image.h"
#include "render_test/settings/toml_values.h"

namespace lancret {
namespace {

constexpr double kMaxLight = 1e6;

DistantLight distant_light(const TomlTable& table, float strength) {
    DistantLight light;
    assign_if(light.direction, direction_value(table, "direction"));
    light.irradiance =
        strength *
        colour_value(table, "irradiance", kMaxLight).value_or(Vec3f(Vec3f::Constant(2)));
    assign_if(light.angular_radius, angle_value(table, "radius_degrees", 0.03, 80));
    return light;
}

Vec3f required_place(const TomlTable& table, std::string_view key, const char* message) {
    const auto place = place_value(table, key);
    if (!place) table.fail(key, message);
    return *place;
}

RectangleLight rectangle_light(const TomlTable& table, const Vec3f& up, float strength) {
    RectangleLight light;
    light.centre =
        required_place(table, "position", "a rectangle of light needs a 'position'");
    light.normal =
        required_place(table, "target",
                       "a rectangle of light needs a 'target', the point that it faces") -
        light.centre;
    if (!(light.normal.norm() > 0)) {
        table.fail("target", "'target' must not be the light's 'position'");
    }
    light.up = up;
    if (const auto size = table.pair("size")) {
        if (!(size->minCoeff() >= 1e-3 && size->maxCoeff() <= 1e6)) {
            table.fail("size", "'size' must be [width, height], from 1e-3 to 1e6 cm");
        }
        light.size = size->cast<float>();
    }
    light.radiance =
        strength *
        colour_value(table, "radiance", kMaxLight).value_or(Vec3f(Vec3f::Constant(10)));
    return light;
}

SphereLight sphere_light(const TomlTable& table, float strength) {
    SphereLight light;
    light.centre =
        required_place(table, "position", "a sphere of light needs a 'position'");
    assign_if(light.radius, table.number("radius", 1e-3, 1e6));
    light.radiance =
        strength *
        colour_value(table, "radiance", kMaxLight).value_or(Vec3f(Vec3f::Constant(10)));
    return light;
}

}  // namespace

std::optional<Lights> read_lights(const TomlTable& light, const Vec3f& up) {
    const auto sky = colour_value(light, "sky", kMaxLight);
    const auto file = light.path("environment");
    const auto rotation = angle_value(light, "rotation_degrees", -360, 360);
    const float strength = float(light.number("strength", 0, 1e6).value_or(1));
    const auto sun = direction_value(light, "key_direction");
    const auto irradiance = colour_value(light, "key", kMaxLight);
    const auto radius = angle_value(light, "key_radius_degrees", 0.03, 80);
    std::vector<DistantLight> distant;
    std::vector<RectangleLight> rectangles;
    std::vector<SphereLight> spheres;
    for (const TomlTable& table : light.tables("distant")) {
        distant.push_back(distant_light(table, strength));
    }
    for (const TomlTable& table : light.tables("rectangle")) {
        rectangles.push_back(rectangle_light(table, up, strength));
    }
    for (const TomlTable& table : light.tables("sphere")) {
        spheres.push_back(sphere_light(table, strength));
    }
    const bool others = !distant.empty() || !rectangles.empty() || !spheres.empty();
    if (sky && file) light.fail("sky", "use a 'sky' or an 'environment', not both");
    if (rotation && !file) {
        light.fail("rotation_degrees", "'rotation_degrees' needs an 'environment'");
    }
    if (radius && !sun && !irradiance) {
        light.fail("key_radius_degrees",
                   "'key_radius_degrees' needs a 'key' or 'key_direction'");
    }
    if (!sky && !file && !sun && !irradiance && !others) {
        if (light.has("strength")) {
            light.fail("strength", "'strength' needs a 'sky', 'environment' or 'key'");
        }
        return std::nullopt;
    }
    Environment environment(
        Vec3f(strength * sky.value_or(Vec3f::Constant(others ? 0.0f : 0.4f))));
    if (file) {
        Texture map = read_texture(*file);
        for (Vec3f& texel : map.texels) texel *= strength;
        environment = Environment(std::move(map), up, rotation.value_or(0));
    }
    if (sun || irradiance) {
        DistantLight key;
        assign_if(key.direction, sun);
        key.irradiance = strength * irradiance.value_or(Vec3f(Vec3f::Constant(2)));
        assign_if(key.angular_radius, radius);
        distant.push_back(key);
    }
    return Lights(std::move(environment), distant, rectangles, spheres);
}

}  // namespace lancret
