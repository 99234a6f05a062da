#include "render_test/groom_shading.h"

#include <cmath>

#include "render_test/sampling.h"

namespace lancret {

Vec3f groom_value(const Vec3f& colour, const Vec3f& wi) {
    // wo's azimuth is that of z, so the cosine of the difference is z over the length
    // across the strand, and that length is the cosine of the inclination.
    const float cosine = std::hypot(wi.y(), wi.z());
    return colour * ((cosine + wi.z()) / (kPi * kPi));
}

Vec3f groom_radiance(const RenderScene& scene, const Ray& ray, const Hit& hit,
                     Sampler& sampler, RayCounter& counter) {
    const Vec2f light_random = sampler.next(), picks = sampler.next();
    const LightSample light = scene.lights.sample(hit.position, picks.x(), light_random);
    if (!(light.pdf > 0)) return Vec3f::Zero();
    Vec3f value;
    Vec3f side = hit.facing;
    if (hit.ribbon) {
        side = hit.shading_normal;
        const Vec3f wo = frame_about(side).transpose() * -ray.direction;
        value = Blade(scene.blade, scene.hair.colour(hit.strand, hit.along), wo)
                    .evaluate(frame_about(side).transpose() * light.direction)
                    .value;
    } else if (hit.kind == Hit::Kind::strand) {
        Mat3f frame;
        frame << hit.tangent, hit.facing.cross(hit.tangent), hit.facing;
        value = groom_value(scene.hair.colour(hit.strand, hit.along),
                            frame.transpose() * light.direction);
    } else {
        side = hit.shading_normal;
        const Mat3f frame = frame_about(side);
        value =
            Lambert(scene.mesh, hit).evaluate(frame.transpose() * light.direction).value;
    }
    const Vec3f arrives = value.cwiseProduct(light.radiance) / light.pdf;
    if (!(arrives.maxCoeff() > 0)) return Vec3f::Zero();
    Ray shadow = ray_from(hit, side, light.direction, ray.time);
    shadow.far = light.distance * (1 - 1e-5f);
    return counter.occluded(shadow) ? Vec3f(kGroomShadowLight * arrives) : arrives;
}

}  // namespace lancret
