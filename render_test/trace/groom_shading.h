#pragma once
// Fast shading for grooming: colour, direction and shadow of strands by two rays per
// sample, without light from strand to strand.

#include "render_test/sampling/sampler.h"
#include "render_test/trace/rays.h"
#include "render_test/trace/render_scene.h"

namespace lancret {

/// A strand as a thin diffuse cylinder, lit most from the viewer's side: colour / pi^2
/// times the cosine of wi's inclination (Kajiya and Kay's diffuse term, 1989) times 1 +
/// the cosine of the azimuth between wi and wo. Local axes as of HairBsdf. The value
/// includes the cosine and integrates to the colour over the sphere.
Vec3f groom_value(const Vec3f& colour, const Vec3f& wi);

/// Share of light that passes through any occluder; it stands for light from strand to
/// strand.
inline constexpr float kGroomShadowLight = 0.15f;

/// Direct light from one light at `hit`.
Vec3f groom_radiance(const RenderScene& scene, const Ray& ray, const Hit& hit,
                     Sampler& sampler, RayCounter& counter);

}  // namespace lancret
