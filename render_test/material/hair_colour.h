#pragma once
// The absorption of a strand, from its pigments or from its intended colour.

#include <cstdint>
#include <optional>

#include "guides/base/types.h"

namespace lancret {

/// The material of hair, as set by a user.
struct HairMaterial {
    float eumelanin = 1.3f;        ///< concentration >= 0: 0.3 blond, 1.3 brown, 8 black
    float pheomelanin = 0;         ///< concentration >= 0: red
    std::optional<Vec3f> colour;   ///< linear RGB in (0, 1): replaces the pigments
    std::optional<Vec3f> sigma_a;  ///< absorption per radius, >= 0: replaces both
    float beta_m = 0.3f;           ///< longitudinal roughness, 0.01 to 1
    float beta_n = 0.3f;           ///< azimuthal roughness, 0.01 to 1
    float tilt = 0.035f;           ///< of the cuticle's scales, radian (2 degrees)
    float eta = 1.55f;             ///< index of refraction, 1.01 to 5
    float aspect = 1;  ///< of a strand's section, minor over major axis, 0.1 to 1

    float melanin_variation = 0;    ///< 0..1: absorption varies by 1 -+ this factor
    float roughness_variation = 0;  ///< 0..1: roughness varies by 1 -+ this factor
    std::optional<Vec3f> root_colour, tip_colour;  ///< linear RGB: replaces the
                                                   ///< colour at that end
    std::uint64_t seed = 0;                        ///< of the variation
};

/// Absorption coefficient of pigments, per strand radius, RGB [Chiang et al. 2016;
/// spectra of d'Eon et al. 2011].
Vec3f sigma_a_of_melanin(float eumelanin, float pheomelanin);

/// Throws std::invalid_argument if a colour is not within 0 and 1.
void check_hair_colour(const Vec3f& colour);

/// The absorption at which a dense groom of azimuthal roughness `beta_n` has
/// approximately this colour after many bounces [Chiang et al. 2016, Eq. 9]. Colours are
/// clamped to [0.001, 0.999].
Vec3f sigma_a_of_colour(const Vec3f& colour, float beta_n);

/// The colour of such a groom: the inverse of sigma_a_of_colour.
Vec3f colour_of_sigma_a(const Vec3f& sigma_a, float beta_n);

/// The absorption of a material, ignoring root_colour and tip_colour. Throws
/// std::invalid_argument if a value is out of range.
Vec3f sigma_a_of(const HairMaterial& material);

/// The same material with both roughnesses at least `minimum` (0.01 to 1). Absorption is
/// unchanged, even if set by a colour. Throws as sigma_a_of.
HairMaterial roughened(const HairMaterial& material, float minimum);

}  // namespace lancret
