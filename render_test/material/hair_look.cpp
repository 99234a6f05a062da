#include "render_test/material/hair_look.h"

#include <algorithm>
#include <stdexcept>

#include "guides/base/hash.h"

namespace lancret {
namespace {

/// Salts of a strand's random numbers; any two different constants.
constexpr std::uint64_t kMelaninSalt = 0x6d656c61, kRoughnessSalt = 0x726f7567;

constexpr int kRoughnesses = 17;

HairMaterial with_roughness(HairMaterial material, float factor) {
    material.beta_m = std::clamp(material.beta_m * factor, 0.01f, 1.0f);
    material.beta_n = std::clamp(material.beta_n * factor, 0.01f, 1.0f);
    return material;
}

Vec3f end_sigma(const HairMaterial& material, const std::optional<Vec3f>& colour) {
    if (!colour) return sigma_a_of(material);
    check_hair_colour(*colour);
    return sigma_a_of_colour(*colour, material.beta_n);
}

}  // namespace

HairLook::HairLook(HairModel model)
    : models_{model},
      far_tables_(std::make_shared<FarTables>(1)),
      root_(model.sigma_a),
      tip_(model.sigma_a) {}

HairLook::HairLook(const HairMaterial& material, float min_roughness)
    : root_(end_sigma(material, material.root_colour)),
      tip_(end_sigma(material, material.tip_colour)),
      melanin_variation_(material.melanin_variation),
      beta_n_(material.beta_n),
      seed_(material.seed) {
    for (const float v : {material.melanin_variation, material.roughness_variation}) {
        if (!(v >= 0 && v <= 1)) {
            throw std::invalid_argument("hair variation must be within 0 and 1");
        }
    }
    if (!(min_roughness >= 0 && min_roughness <= 1)) {
        throw std::invalid_argument("minimum hair roughness must be within 0 and 1");
    }
    const HairModel unvaried(material);  // throws if a value is out of range
    const int levels = material.roughness_variation > 0 ? kRoughnesses : 1;
    for (int i = 0; i < levels; ++i) {
        const float share = levels > 1 ? 2 * float(i) / float(levels - 1) - 1 : 0;
        const HairMaterial varied =
            with_roughness(material, 1 + share * material.roughness_variation);
        models_.emplace_back(roughened(varied, min_roughness));
    }
    far_tables_ = std::make_shared<FarTables>(models_.size());
}

std::size_t HairLook::level(std::uint32_t strand) const {
    if (models_.size() == 1) return 0;
    const float random = unit_float(hash_bits(seed_, strand, kRoughnessSalt));
    // The nearest level; the outermost get half as many strands.
    return std::size_t(random * float(kRoughnesses - 1) + 0.5f);
}

Vec3f HairLook::sigma_a(std::uint32_t strand, float along) const {
    const Vec3f sigma = root_ + along * (tip_ - root_);
    if (melanin_variation_ == 0) return sigma;
    const float random = unit_float(hash_bits(seed_, strand, kMelaninSalt));
    return (1 + melanin_variation_ * (2 * random - 1)) * sigma;
}

Vec3f HairLook::colour(std::uint32_t strand, float along) const {
    return colour_of_sigma_a(sigma_a(strand, along), beta_n_);
}

}  // namespace lancret
