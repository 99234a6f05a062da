#pragma once
// Scattering along the strand: the longitudinal M of each lobe, which is independent of
// the offset h.

#include "render_test/material/hair_bsdf.h"

namespace lancret {

/// For a unit wo whose inclination has this sine and cosine.
TurnedInclination turned_inclination(const HairModel& model, float sine_o,
                                     float cosine_o);

/// M of each lobe, 1/sr times cosine; integrates to one over sin(inclination of wi)
/// [d'Eon et al. 2011, Eq. 7].
Eigen::Array4f longitudinal(const HairModel& model, const TurnedInclination& wo,
                            float sine_i, float cosine_i);

/// The sine of an inclination of wi, sampled from a lobe's M; `random` in [0, 1).
float sampled_sine(const HairModel& model, const TurnedInclination& wo, int lobe,
                   const Vec2f& random);

/// Length of a unit direction projected across the strand: the cosine of its inclination.
float length_across(const Vec3f& w);

}  // namespace lancret
