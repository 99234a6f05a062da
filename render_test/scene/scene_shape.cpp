#include "render_test/scene/scene_shape.h"

#include <algorithm>
#include <cmath>

#include "render_test/scene/thin_strands.h"

namespace lancret {
namespace {

/// `v` projected across the unit vector `axis`, normalised; any vector across `axis` if
/// `v` is parallel to it.
Vec3f unit_across(const Vec3f& v, const Vec3f& axis) {
    const Vec3f across = v - axis * axis.dot(v);
    const float length = across.norm();
    return length > 1e-6f ? Vec3f(across / length) : Vec3f(axis.unitOrthogonal());
}

/// Unit, root to tip; any vector across the ray if the derivative of the axis is zero.
Vec3f tangent_of(const AxisPoint& axis, const Vec3f& direction) {
    const Vec3f along = axis.derivative.head<3>();
    const float speed = along.norm();
    return speed > 0 ? Vec3f(along / speed) : Vec3f(direction.unitOrthogonal());
}

/// The position of a ray time between two scene times.
struct TimeSegment {
    std::size_t from = 0;
    float share = 0;
};

/// Divides ray time as Embree does for this number of scene times.
TimeSegment time_segment(float time, std::size_t times) {
    const float scaled = time * float(times - 1);
    const float from = std::clamp(std::floor(scaled), 0.0f, float(times - 2));
    return {std::size_t(from), scaled - from};
}

}  // namespace

float SceneShape::opacity(std::uint32_t segment, float u, float drawn) const {
    const float true_radius = radius_at(*curves[0], true_radii, segment, u);
    return drawn > 0 ? std::clamp(true_radius / drawn, 0.0f, 1.0f) : 1.0f;
}

AxisPoint SceneShape::axis(std::uint32_t segment, float u, float time) const {
    if (times() == 1) return axis_point(*curves[0], segment, u);
    const auto [from, share] = time_segment(time, times());
    return axis_point(*curves[from], *curves[from + 1], share, segment, u);
}

StrandSection SceneShape::section(std::uint32_t segment, float u, float time,
                                  const Vec3f& tangent, const Vec3f& facing) const {
    Vec3f face;
    if (times() == 1) {
        face = face_normal(*curves[0], segment, u);
    } else {
        const auto [from, share] = time_segment(time, times());
        face = (1 - share) * face_normal(*curves[from], segment, u) +
               share * face_normal(*curves[from + 1], segment, u);
    }
    const Vec3f major = tangent.cross(unit_across(face, tangent));
    return {aspect, std::atan2(major.dot(facing), major.dot(facing.cross(tangent)))};
}

bool SceneShape::within_section(std::uint32_t segment, float u, float v, float time,
                                const Vec3f& direction) const {
    const Vec3f tangent = tangent_of(axis(segment, u, time), direction);
    const Vec3f facing = unit_across(-direction, tangent);
    return std::abs(v) <= section(segment, u, time, tangent, facing).half_width();
}

Vec3f SceneShape::vertex(std::uint32_t i, float time) const {
    if (times() == 1) return mesh.positions[i];
    const auto [from, share] = time_segment(time, times());
    return (1 - share) * vertices_at(from)[i] + share * vertices_at(from + 1)[i];
}

Vec3f SceneShape::corner_normal(std::uint32_t triangle, int corner, float time) const {
    if (times() == 1) return normals[0][triangle][corner];
    const auto [from, share] = time_segment(time, times());
    return (1 - share) * normals[from][triangle][corner] +
           share * normals[from + 1][triangle][corner];
}

void SceneShape::complete_strand(const Ray& ray, Hit& hit) const {
    hit.kind = Hit::Kind::strand;
    StrandHit& strand = hit.strand;
    const SegmentPlace place = curves[0]->place_of(hit.primitive);
    strand.index = place.strand;
    strand.id = curves[0]->id_of(strand.index);
    const AxisPoint here = axis(hit.primitive, hit.u, ray.time);
    strand.radius = here.value.w();
    strand.along = (float(place.in_strand) + hit.u) / float(place.of);
    if (!true_radii.empty() && !ray.by_chance) {
        strand.opacity = opacity(hit.primitive, hit.u, strand.radius);
    }
    hit.tangent = tangent_of(here, ray.direction);
    strand.facing = unit_across(-ray.direction, hit.tangent);
    const Vec3f across = strand.facing.cross(hit.tangent);
    if (curves[0]->shape == CurveShape::ribbon) {
        // Between two times whose normals oppose each other there may be no normal left.
        const float length = hit.normal.norm();
        hit.normal = length > 0 && std::isfinite(length) ? Vec3f(hit.normal / length)
                                                         : strand.facing;
        hit.shading_normal =
            hit.normal.dot(ray.direction) > 0 ? Vec3f(-hit.normal) : hit.normal;
        strand.offset = hit.position - here.value.head<3>();
        strand.ribbon = true;
    } else if (curves[0]->shape == CurveShape::flat) {
        hit.normal = strand.facing;
        strand.h = std::clamp(-hit.v, -1.0f, 1.0f);
        strand.offset = strand.h * strand.radius * across;
        if (aspect < 1) {
            strand.section =
                section(hit.primitive, hit.u, ray.time, hit.tangent, strand.facing);
            strand.h = std::clamp(strand.h / strand.section.half_width(), -1.0f, 1.0f);
        }
    } else {
        hit.normal.normalize();
        const Vec3f outward = unit_across(hit.normal, hit.tangent);
        strand.h = std::clamp(outward.dot(across), -1.0f, 1.0f);
        strand.offset = strand.radius * outward;
    }
}

void SceneShape::complete_mesh(const Ray& ray, Hit& hit) const {
    hit.kind = Hit::Kind::mesh;
    const auto& corners = mesh.triangles[hit.primitive];
    const Vec3f a = vertex(corners[0], ray.time), b = vertex(corners[1], ray.time);
    hit.tangent = (b - a).normalized();
    hit.normal.normalize();
    const float side = hit.normal.dot(ray.direction) < 0 ? 1 : -1;
    hit.shading_normal = side * hit.normal;
    if (!normals.empty()) {
        std::array<Vec3f, 3> smooth;
        for (int k = 0; k < 3; ++k) {
            smooth[k] = side * corner_normal(hit.primitive, k, ray.time);
        }
        const SmoothPlace place =
            smooth_place({a, b, vertex(corners[2], ray.time)}, smooth,
                         Vec3f(1 - hit.u - hit.v, hit.u, hit.v), hit.position,
                         hit.shading_normal, -ray.direction);
        hit.shading_normal = place.normal;
        hit.mesh.lift = place.lift;
    }
    if (mesh.uvs.empty()) return;
    const auto& uv = mesh.uvs[hit.primitive];
    hit.mesh.uv = (1 - hit.u - hit.v) * uv[0] + hit.u * uv[1] + hit.v * uv[2];
}

}  // namespace lancret
