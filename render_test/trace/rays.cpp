#include "render_test/trace/rays.h"

#include <algorithm>
#include <cmath>

namespace lancret {

std::optional<Hit> RayCounter::intersect(const Ray& ray) {
    ++rays;
    if (record) record->push_back({ray, false});
    return geometry.intersect(ray);
}

bool RayCounter::occluded(const Ray& shadow) {
    ++rays;
    if (record) record->push_back({shadow, true});
    return geometry.occluded(shadow);
}

Ray ray_from(const Hit& hit, const Vec3f& side, const Vec3f& direction, float time) {
    Ray ray;
    ray.direction = direction;
    ray.time = time;
    const float rounding = 1e-5f * (1 + hit.position.cwiseAbs().maxCoeff());
    if (hit.strand.ribbon) {
        // Embree finds a ribbon's surface to about a thousandth of its width.
        const float off = rounding + 2e-3f * hit.strand.radius;
        ray.origin = hit.position + (direction.dot(side) < 0 ? -off : off) * side;
    } else if (hit.kind == Hit::Kind::strand) {
        ray.origin = hit.position;
        ray.near = strand_clearance(hit, direction) + 0.1f * rounding;
    } else {
        ray.origin = hit.position + hit.mesh.lift + rounding * side;
    }
    return ray;
}

float strand_clearance(const Hit& hit, const Vec3f& direction) {
    const Vec3f& offset = hit.strand.offset;
    const Vec3f across = direction - hit.tangent * hit.tangent.dot(direction);
    const float cosine = std::max(across.norm(), 1e-6f);
    const float inward = offset.dot(across) / cosine;
    const float r2 = hit.strand.radius * hit.strand.radius;
    const float exit =
        std::sqrt(std::max(0.0f, inward * inward + r2 - offset.squaredNorm())) - inward;
    return (1.01f * exit + 0.02f * hit.strand.radius) / std::max(cosine, 0.1f);
}

}  // namespace lancret
