#pragma once
// What a strand absorbs, from its pigments or from the colour it should look like.

#include <cstdint>
#include <optional>

#include "guides/base/types.h"

namespace lancret {

/// What a strand is made of, as a user says it.
struct HairMaterial {
    float eumelanin = 1.3f;        ///< concentration >= 0: 0.3 blond, 1.3 brown, 8 black
    float pheomelanin = 0;         ///< concentration >= 0: red
    std::optional<Vec3f> colour;   ///< linear RGB in (0, 1): stands in for the pigments
    std::optional<Vec3f> sigma_a;  ///< absorption a radius, >= 0: stands in for both
    float beta_m = 0.3f;           ///< longitudinal roughness, 0.01 to 1
    float beta_n = 0.3f;           ///< azimuthal roughness, 0.01 to 1
    float tilt = 0.035f;           ///< of the cuticle's scales, radian (2 degrees)
    float eta = 1.55f;             ///< index of refraction, 1.01 to 5
    float aspect = 1;  ///< of a strand's section, minor over major axis, 0.1 to 1

    float melanin_variation = 0;    ///< 0..1: a strand absorbs 1 -+ this times as much
    float roughness_variation = 0;  ///< 0..1: and is 1 -+ this times as rough
    std::optional<Vec3f> root_colour, tip_colour;  ///< linear RGB: in place of the
                                                   ///< material's own at that end
    std::uint64_t seed = 0;                        ///< of the variation
};

/// Absorption coefficient of pigments, per strand radius, RGB [Chiang et al. 2016; the
/// spectra of d'Eon et al. 2011].
Vec3f sigma_a_of_melanin(float eumelanin, float pheomelanin);

/// Throws std::invalid_argument where a colour is not within 0 and 1.
void check_hair_colour(const Vec3f& colour);

/// The absorption at which a dense groom of azimuthal roughness `beta_n` shows about this
/// colour under many bounces [Chiang et al. 2016, Eq. 9]. Colours are kept in
/// [0.001, 0.999].
Vec3f sigma_a_of_colour(const Vec3f& colour, float beta_n);

/// The colour that such a groom shows: the inverse of sigma_a_of_colour.
Vec3f colour_of_sigma_a(const Vec3f& sigma_a, float beta_n);

/// What the material says, but for root_colour and tip_colour; throws
/// std::invalid_argument where a value is out of its range.
Vec3f sigma_a_of(const HairMaterial& material);

/// The same fibre with both roughnesses at least `least` (0.01 to 1). It absorbs as
/// before, even where a colour was given. Throws as sigma_a_of.
HairMaterial widened(const HairMaterial& material, float least);

}  // namespace lancret
