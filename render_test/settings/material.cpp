#include "render_test/settings/material.h"

#include "render_test/files/read_image.h"
#include "render_test/settings/toml_values.h"

namespace lancret {
namespace {

/// Presets by their eumelanin.
constexpr Named<float> kPresets[] = {{0.3f, "blond"}, {1.3f, "brown"}, {8.0f, "black"}};

/// Whether the shading is that of grooming tools.
constexpr Named<bool> kShadings[] = {{false, "path"}, {true, "groom"}};

}  // namespace

void read_material(const TomlTable& material, HairMaterial& hair, MeshMaterial& mesh,
                   bool& groom_shading) {
    const auto preset = material.choice("preset", kPresets);
    assign_if(hair.eumelanin, preset);
    const auto colour = colour_value(material, "colour", 1);
    if (preset && (colour || material.has("eumelanin"))) {
        material.fail("preset",
                      "a 'preset' sets the melanin: remove 'eumelanin' and 'colour'");
    }
    if (colour) hair.colour = colour;
    assign_if(hair.eumelanin, material.number("eumelanin", 0, 100));
    assign_if(hair.pheomelanin, material.number("pheomelanin", 0, 100));
    assign_if(hair.beta_m, material.number("roughness", 0.01, 1));
    assign_if(hair.beta_n, material.number("azimuthal_roughness", 0.01, 1));
    assign_if(hair.tilt, angle_value(material, "tilt_degrees", -20, 20));
    assign_if(hair.eta, material.number("eta", 1.01, 5));
    assign_if(hair.aspect, material.number("aspect", 0.1, 1));
    assign_if(hair.melanin_variation, material.number("melanin_variation", 0, 1));
    assign_if(hair.roughness_variation, material.number("roughness_variation", 0, 1));
    assign_if(hair.seed, material.integer("seed", 0, std::int64_t(1) << 62));
    if (const auto value = colour_value(material, "root_colour", 1)) {
        hair.root_colour = value;
    }
    if (const auto value = colour_value(material, "tip_colour", 1)) {
        hair.tip_colour = value;
    }
    assign_if(groom_shading, material.choice("shading", kShadings));
    assign_if(mesh.colour, colour_value(material, "scalp_colour", 1));
    assign_if(mesh.coat_roughness, material.number("scalp_roughness", 0.05, 1));
    if (const auto file = material.path("scalp_texture")) {
        mesh.texture = read_texture(*file);
    }
}

}  // namespace lancret
