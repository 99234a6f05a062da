#include "render_test/trace/groom_shading.h"

#include <cmath>

#include "render_test/light/light_choice.h"
#include "render_test/sampling/sampling.h"

namespace lancret {

Vec3f groom_value(const Vec3f& colour, const Vec3f& wi) {
    // wo's azimuth is that of z, so the cosine of the difference is z over the length
    // across the strand, and that length is the cosine of the inclination.
    const float cosine = std::hypot(wi.y(), wi.z());
    return colour * ((cosine + wi.z()) / (kPif * kPif));
}

Vec3f groom_radiance(const RenderScene& scene, const Ray& ray, const Hit& hit,
                     Sampler& sampler, RayCounter& counter) {
    const Vec2f light_random = sampler.next(), picks = sampler.next();
    Mat3f frame;
    if (hit.kind == Hit::Kind::strand && !hit.strand.ribbon) {
        frame << hit.tangent, hit.strand.facing.cross(hit.tangent), hit.strand.facing;
    } else {
        frame = frame_about(hit.shading_normal);
    }
    std::optional<Blade> blade;
    if (hit.strand.ribbon) {
        blade.emplace(scene.blade, scene.hair.colour(hit.strand.id, hit.strand.along),
                      frame.transpose() * -ray.direction);
    }
    const auto value = [&](const Vec3f& wi) -> Vec3f {
        if (hit.kind == Hit::Kind::mesh) {
            return Lambert(scene.mesh, hit).evaluate(wi).value;
        }
        if (blade) return blade->evaluate(wi).value;
        return groom_value(scene.hair.colour(hit.strand.id, hit.strand.along), wi);
    };
    const ChosenLight chosen = choose_light(
        scene.lights, hit.position, picks.x(), light_random, [&](const LightSample& l) {
            return Vec3f(value(frame.transpose() * l.direction).cwiseProduct(l.radiance) /
                         l.pdf);
        });
    if (!(chosen.contribution.maxCoeff() > 0)) return Vec3f::Zero();
    Ray shadow = ray_from(hit, frame.col(2), chosen.light.direction, ray.time);
    shadow.far = chosen.light.distance * (1 - 1e-5f);
    return counter.occluded(shadow) ? Vec3f(kGroomShadowLight * chosen.contribution)
                                    : chosen.contribution;
}

}  // namespace lancret
