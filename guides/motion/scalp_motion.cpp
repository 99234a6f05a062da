#include "guides/motion/scalp_motion.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <string_view>

#include "guides/base/errors.h"

namespace lancret {

namespace {

/// A vector and its first and second derivative in time.
using Moving = std::array<Vec3, 3>;

Moving difference(const VertexMotion& a, const VertexMotion& b) {
    return {a.position - b.position, a.velocity - b.velocity,
            a.acceleration - b.acceleration};
}

Moving cross(const Moving& a, const Moving& b) {
    return {a[0].cross(b[0]), a[1].cross(b[0]) + a[0].cross(b[1]),
            a[2].cross(b[0]) + 2 * a[1].cross(b[1]) + a[0].cross(b[2])};
}

/// v / |v|, v not zero.
Moving unit(const Moving& v) {
    const double s = v[0].norm();
    const Vec3 g = v[0] / s;
    const double s1 = g.dot(v[1]);
    const Vec3 g1 = (v[1] - g * s1) / s;
    const double s2 = g1.dot(v[1]) + g.dot(v[2]);
    return {g, g1, (v[2] - 2 * g1 * s1 - g * s2) / s};
}

/// The frame of a triangle: unit first edge, unit normal, and across both.
std::array<Moving, 3> triangle_frame(const std::array<VertexMotion, 3>& p,
                                     std::uint32_t triangle, std::string_view name) {
    const Moving e1 = difference(p[1], p[0]), e2 = difference(p[2], p[0]);
    const Moving area = cross(e1, e2);
    const double size = std::max(e1[0].squaredNorm(), e2[0].squaredNorm());
    if (!(area[0].norm() > 1e-9 * size)) {
        throw InputError(
            fmt::format("{}: triangle {} under a root has no area", name, triangle));
    }
    const Moving edge = unit(e1), normal = unit(area);
    return {edge, normal, cross(edge, normal)};
}

Mat3 columns(const std::array<Moving, 3>& frame) {
    Mat3 m;
    m << frame[0][0], frame[1][0], frame[2][0];
    return m;
}

RootMotion motion_of(const RigidMotion& rigid, const RestRoot& root) {
    RootMotion out;
    out.pose.frame = rigid.pose.rotation * root.pose.frame;
    out.pose.position = rigid.pose * root.pose.position;
    const Vec3 arm = out.pose.position - rigid.pivot, w = rigid.angular_velocity;
    out.velocity = rigid.velocity + w.cross(arm);
    out.acceleration = rigid.acceleration + rigid.angular_acceleration.cross(arm) +
                       w.cross(w.cross(arm));
    out.angular_velocity = w;
    out.angular_acceleration = rigid.angular_acceleration;
    return out;
}

RootMotion motion_of(const MeshMotion& mesh, const RestRoot& root) {
    if (!root.point || root.point->triangle >= mesh.rest->triangles.size()) {
        throw std::invalid_argument("root_motion: the root is not on the mesh");
    }
    const auto& t = mesh.rest->triangles[root.point->triangle];
    std::array<VertexMotion, 3> now, rest;
    for (std::size_t c = 0; c < 3; ++c) {
        now[c] = vertex_motion(mesh, t[c]);
        rest[c].position = mesh.rest->positions[t[c]].cast<double>();
    }
    const double u = root.point->u, v = root.point->v;
    const auto point = [&](Vec3 VertexMotion::*of) -> Vec3 {
        return now[0].*of + u * (now[1].*of - now[0].*of) + v * (now[2].*of - now[0].*of);
    };
    RootMotion out;
    out.pose.position = point(&VertexMotion::position);
    out.velocity = point(&VertexMotion::velocity);
    out.acceleration = point(&VertexMotion::acceleration);

    const auto frame = triangle_frame(now, root.point->triangle, mesh.name);
    const auto rest_frame = triangle_frame(rest, root.point->triangle, "the rest mesh");
    out.pose.frame = columns(frame) * columns(rest_frame).transpose() * root.pose.frame;
    // From f' = w x f of each column: the sum of f x f' is 2 w.
    for (const Moving& f : frame) {
        out.angular_velocity += 0.5 * f[0].cross(f[1]);
        out.angular_acceleration += 0.5 * f[0].cross(f[2]);
    }
    return out;
}

}  // namespace

ScalpTime scalp_at(const ScalpMotion& motion, double frame) {
    if (const auto* path = std::get_if<RigidPath>(&motion)) {
        return rigid_motion(*path, frame);
    }
    return std::get<MeshSequence>(motion).at(frame);
}

RootMotion root_motion(const ScalpTime& scalp, const RestRoot& root) {
    return std::visit([&](const auto& time) { return motion_of(time, root); }, scalp);
}

TriangleMesh posed(const ScalpTime& scalp, TriangleMesh rest) {
    if (const auto* rigid = std::get_if<RigidMotion>(&scalp)) {
        for (Vec3f& p : rest.positions) {
            p = (rigid->pose * p.cast<double>()).cast<float>();
        }
        return rest;
    }
    const auto& mesh = std::get<MeshMotion>(scalp);
    if (rest.positions.size() != mesh.rest->positions.size()) {
        throw std::invalid_argument("posed: expected the rest mesh of the sequence");
    }
    for (std::uint32_t i = 0; i < rest.positions.size(); ++i) {
        rest.positions[i] = vertex_motion(mesh, i).position.cast<float>();
    }
    return rest;
}

}  // namespace lancret
