#include "render_test/check_view.h"

#include <algorithm>
#include <cmath>

#include "render_test/colour_map.h"
#include "render_test/path_tracer.h"

namespace lancret {

namespace {

Vec3f strand_colour(const CheckView& view, const Hit& hit) {
    return view.colours.empty() ? scale_colour(view.scale, view_value(view, hit))
                                : view.colours[hit.strand];
}

/// 1 where a surface faces the ray, kLeastShade where it is seen from its edge.
float shade(float cosine) { return kLeastShade + (1 - kLeastShade) * std::abs(cosine); }

bool is_clean(const CheckView& view, const Hit& hit) {
    return view.scale.clean && view_value(view, hit) <= *view.scale.clean;
}

}  // namespace

float scale_place(const ColourScale& scale, float value) {
    const auto place = [](double x, double low, double high) {
        return float(std::clamp((x - low) / (high - low), 0.0, 1.0));
    };
    if (scale.kind != ColourScale::Kind::logarithmic) {
        return place(value, scale.low, scale.high);
    }
    return value > 0 ? place(std::log(value), std::log(scale.low), std::log(scale.high))
                     : 0;
}

Vec3f scale_colour_at(const ColourScale& scale, float at) {
    return scale.kind == ColourScale::Kind::diverging ? diverging_colour(2 * at - 1)
                                                      : sequential_colour(at);
}

Vec3f scale_colour(const ColourScale& scale, float value) {
    if (!scale.over.empty() && value > scale.high) return kFailColour;
    if (scale.clean && value <= *scale.clean) return kCleanColour;
    return scale_colour_at(scale, scale_place(scale, value));
}

float view_value(const CheckView& view, const Hit& hit) {
    return hit.kind == Hit::Kind::strand ? view.values.at(hit.strand, hit.along) : 0;
}

Vec3f view_radiance(const CheckView& view, const Ray& ray, const Hit& hit,
                    RayCounter& counter) {
    if (hit.kind == Hit::Kind::strand) {
        const float across = std::sqrt(std::max(0.0f, 1 - hit.h * hit.h));
        return strand_colour(view, hit) * shade(hit.facing.dot(ray.direction) * across);
    }
    const Vec3f mesh = Vec3f::Constant(0.06f * shade(hit.normal.dot(ray.direction)));
    if (!view.through_mesh) return mesh;
    Ray on = ray;
    on.by_chance = true;
    on.near = hit.distance + 1e-5f * (1 + hit.position.cwiseAbs().maxCoeff());
    const std::optional<Hit> below = counter.intersect(on);
    if (!below || below->kind != Hit::Kind::strand || is_clean(view, *below)) return mesh;
    return 0.6f * strand_colour(view, *below) + 0.4f * mesh;
}

}  // namespace lancret
