#include "render_test/trace/check_view.h"

#include <algorithm>
#include <cmath>

namespace lancret {

namespace {

Vec3f strand_colour(const CheckView& view, const Hit& hit) {
    return view.colours.empty() ? scale_colour(view.scale, view_value(view, hit))
                                : view.colours[hit.strand.index];
}

/// 1 if a surface faces the ray, kMinShade if it is seen edge-on.
float shade(float cosine) { return kMinShade + (1 - kMinShade) * std::abs(cosine); }

constexpr int kMaxLayers = 256;  // surfaces that a ray may pass
constexpr float kSeenThrough = 0.6f;

bool is_clean(const CheckView& view, const Hit& hit) {
    return hit.kind == Hit::Kind::mesh ||
           (view.scale.clean && view_value(view, hit) <= *view.scale.clean);
}

/// The colour at the hit itself, without what shows through.
Vec3f surface_colour(const CheckView& view, const Ray& ray, const Hit& hit) {
    if (hit.kind == Hit::Kind::mesh) {
        return Vec3f::Constant(0.06f * shade(hit.shading_normal.dot(ray.direction)));
    }
    if (hit.strand.ribbon) {
        return strand_colour(view, hit) * shade(hit.shading_normal.dot(ray.direction));
    }
    const float across = std::sqrt(std::max(0.0f, 1 - hit.strand.h * hit.strand.h));
    return strand_colour(view, hit) *
           shade(hit.strand.facing.dot(ray.direction) * across);
}

/// The first hit behind `front` that is not clean, in front of the mesh or inside it.
std::optional<Hit> first_behind(const CheckView& view, Ray ray, const Hit& front,
                                RayCounter& counter) {
    RayCounter apart{*view.apart->scene};
    int surfaces = 0;
    std::optional<Hit> hit;
    for (int layer = 0; layer < kMaxLayers; ++layer) {
        hit = apart.intersect(ray);
        if (!hit) break;
        if (hit->kind == Hit::Kind::strand) {
            hit->strand.index = view.apart->strands[hit->strand.index];
        }
        if (hit->distance > front.distance && !is_clean(view, *hit)) break;
        surfaces += hit->kind == Hit::Kind::mesh;
        if (surfaces > 1) hit.reset();
        if (!hit) break;
        ray.near = hit->distance +
                   1e-6f * (1 + hit->position.cwiseAbs().maxCoeff() + hit->distance);
        hit.reset();
    }
    counter.rays += apart.rays;
    return hit;
}

}  // namespace

std::shared_ptr<const StrandsApart> strands_apart(const CheckView& view,
                                                  const Curves& curves,
                                                  const TriangleMesh* mesh,
                                                  float aspect) {
    auto out = std::make_shared<StrandsApart>();
    Curves& chosen = out->curves;
    chosen.basis = curves.basis;
    chosen.shape = curves.shape;
    for (const CurveClass& curve_class : curves.classes) {
        const std::size_t before = out->strands.size();
        for (std::uint32_t i = curve_class.strand;
             i < curve_class.strand + curve_class.strands; ++i) {
            if (std::ranges::max(view.values.of(i)) > view.scale.clean.value_or(0)) {
                out->strands.push_back(i);
            }
        }
        chosen.add_class(std::uint32_t(out->strands.size() - before),
                         curve_class.segments);
    }
    const auto pick = [&](const Buffer<Point4f>& from, Buffer<Point4f>& to) {
        to = Buffer<Point4f>(from.size() > 0 ? chosen.point_count() : 0);
        for (std::uint32_t i = 0; i < chosen.strands && from.size() > 0; ++i) {
            std::ranges::copy(curves.of_strand(from, out->strands[i]),
                              to.data() + chosen.first_point(i));
        }
    };
    pick(curves.points, chosen.points);
    pick(curves.tangents, chosen.tangents);
    pick(curves.normals, chosen.normals);
    chosen.segments = Buffer<std::uint32_t>(chosen.segment_count());
    for (std::uint32_t i = 0; i < chosen.segments.size(); ++i) {
        chosen.segments[i] = chosen.place_of(i).point;
    }
    out->scene.emplace(chosen, mesh, HairSceneOptions{.aspect = aspect});
    return out;
}

float view_value(const CheckView& view, const Hit& hit) {
    return hit.kind == Hit::Kind::strand
               ? view.values.at(hit.strand.index, hit.strand.along)
               : 0;
}

Vec3f view_radiance(const CheckView& view, const Ray& ray, const Hit& hit,
                    RayCounter& counter) {
    const Vec3f front = surface_colour(view, ray, hit);
    if (!view.apart || !is_clean(view, hit)) return front;
    const std::optional<Hit> behind = first_behind(view, ray, hit, counter);
    if (!behind) return front;
    return kSeenThrough * strand_colour(view, *behind) + (1 - kSeenThrough) * front;
}

}  // namespace lancret
