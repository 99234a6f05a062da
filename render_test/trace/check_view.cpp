#include "render_test/trace/check_view.h"

#include <algorithm>
#include <cmath>

#include "render_test/image/colour_scale.h"
#include "render_test/trace/path_tracer.h"

namespace lancret {

namespace {

Vec3f strand_colour(const CheckView& view, const Hit& hit) {
    return view.colours.empty() ? scale_colour(view.scale, view_value(view, hit))
                                : view.colours[hit.strand];
}

/// 1 where a surface faces the ray, kMinShade where it is seen from its edge.
float shade(float cosine) { return kMinShade + (1 - kMinShade) * std::abs(cosine); }

constexpr int kMaxLayers = 256;  // looked through
constexpr float kSeenThrough = 0.6f;

bool is_clean(const CheckView& view, const Hit& hit) {
    return hit.kind == Hit::Kind::mesh ||
           (view.scale.clean && view_value(view, hit) <= *view.scale.clean);
}

/// The colour of what is there itself.
Vec3f surface_colour(const CheckView& view, const Ray& ray, const Hit& hit) {
    if (hit.kind == Hit::Kind::mesh) {
        return Vec3f::Constant(0.06f * shade(hit.shading_normal.dot(ray.direction)));
    }
    if (hit.ribbon) {
        return strand_colour(view, hit) * shade(hit.shading_normal.dot(ray.direction));
    }
    const float across = std::sqrt(std::max(0.0f, 1 - hit.h * hit.h));
    return strand_colour(view, hit) * shade(hit.facing.dot(ray.direction) * across);
}

/// The first place that is not clean behind `front`, on this side of the mesh or in it.
std::optional<Hit> first_behind(const CheckView& view, Ray ray, const Hit& front,
                                RayCounter& counter) {
    RayCounter apart{*view.apart->scene};
    int surfaces = 0;
    std::optional<Hit> hit;
    for (int layer = 0; layer < kMaxLayers; ++layer) {
        hit = apart.intersect(ray);
        if (!hit) break;
        if (hit->kind == Hit::Kind::strand)
            hit->strand = view.apart->strands[hit->strand];
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

std::shared_ptr<const StrandsApart> strands_apart(const CheckView& view,
                                                  const Curves& curves,
                                                  const TriangleMesh* mesh,
                                                  float aspect) {
    auto out = std::make_shared<StrandsApart>();
    Curves& chosen = out->curves;
    chosen.basis = curves.basis;
    chosen.shape = curves.shape;
    for (const CurveClass& own : curves.classes) {
        const std::size_t before = out->strands.size();
        for (std::uint32_t i = own.strand; i < own.strand + own.strands; ++i) {
            if (std::ranges::max(view.values.of(i)) > view.scale.clean.value_or(0))
                out->strands.push_back(i);
        }
        chosen.add_class(std::uint32_t(out->strands.size() - before), own.segments);
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
    return hit.kind == Hit::Kind::strand ? view.values.at(hit.strand, hit.along) : 0;
}

Vec3f view_radiance(const CheckView& view, const Ray& ray, const Hit& hit,
                    RayCounter& counter) {
    const Vec3f own = surface_colour(view, ray, hit);
    if (!view.apart || !is_clean(view, hit)) return own;
    const std::optional<Hit> behind = first_behind(view, ray, hit, counter);
    if (!behind) return own;
    return kSeenThrough * strand_colour(view, *behind) + (1 - kSeenThrough) * own;
}

}  // namespace lancret
