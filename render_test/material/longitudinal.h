#pragma once
// How hair spreads light along the strand: the longitudinal M of each lobe. It does not
// depend on the offset h.

#include "render_test/material/hair_bsdf.h"

namespace lancret {

/// Of a unit wo whose inclination has this sine and cosine.
TurnedInclination turned_inclination(const HairModel& model, float sine_o,
                                     float cosine_o);

/// M of each lobe, 1/sr times cosine: integrates to one over sin(inclination of wi)
/// [d'Eon et al. 2011, Eq. 7].
Eigen::Array4f longitudinal(const HairModel& model, const TurnedInclination& wo,
                            float sine_i, float cosine_i);

/// The sine of an inclination of wi, drawn from a lobe's M; `random` in [0, 1).
float sampled_sine(const HairModel& model, const TurnedInclination& wo, int lobe,
                   const Vec2f& random);

/// The part of a unit direction across the strand: the cosine of its inclination.
float length_across(const Vec3f& w);

}  // namespace lancret
