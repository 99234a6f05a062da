#pragma once
// A cheap look for grooming: colour, direction and shadow of strands by two rays a
// sample, without light from strand to strand.

#include "render_test/trace/path_tracer.h"

namespace lancret {

/// A strand as a thin dull cylinder, lit most from the viewer's side: colour / pi^2 times
/// the cosine of wi's inclination (Kajiya and Kay's diffuse term, 1989) times 1 + the
/// cosine of the azimuth between wi and wo. Local axes as HairBsdf's; times cosine: it
/// integrates to the colour over the sphere.
Vec3f groom_value(const Vec3f& colour, const Vec3f& wi);

/// What is seen at `hit`: light straight from one light, of which kGroomShadowLight
/// passes through whatever is between, in place of light from strand to strand.
inline constexpr float kGroomShadowLight = 0.15f;
Vec3f groom_radiance(const RenderScene& scene, const Ray& ray, const Hit& hit,
                     Sampler& sampler, RayCounter& counter);

}  // namespace lancret
