#include "guides/motion/scalp_pose.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "guides/base/errors.h"

namespace lancret {

ScalpPose scalp_pose(const ScalpTime& scalp) {
    if (const auto* rigid = std::get_if<RigidMotion>(&scalp)) return rigid->pose;
    return posed(scalp, *std::get<MeshMotion>(scalp).rest);
}

std::vector<RigidPose> carriers(const ScalpPose& pose, std::span<const MeshPoint> places,
                                std::size_t count) {
    if (const auto* rigid = std::get_if<RigidPose>(&pose)) return {count, *rigid};
    const TriangleMesh& mesh = std::get<TriangleMesh>(pose);
    if (places.size() != count) {
        throw InputError(
            "a posed scalp needs a scalp at rest, but the groom has none; set [scalp] "
            "file");
    }
    std::vector<RigidPose> out(count);
    for (std::size_t i = 0; i < count; ++i) {
        const MeshPoint& place = places[i];
        if (place.triangle >= mesh.triangles.size()) {
            throw std::invalid_argument("carriers: a place is not on the mesh");
        }
        const auto& t = mesh.triangles[place.triangle];
        const auto corner = [&](int c) -> Vec3 {
            return mesh.positions[t[c]].cast<double>();
        };
        const Vec3 origin = corner(0), e1 = corner(1) - origin, e2 = corner(2) - origin;
        const Vec3 area = e1.cross(e2);
        if (!(area.norm() > 1e-9 * std::max(e1.squaredNorm(), e2.squaredNorm()))) {
            throw InputError(fmt::format(
                "the posed scalp: triangle {} under a root has no area", place.triangle));
        }
        const Vec3 edge = e1.normalized(), normal = area.normalized();
        out[i].rotation << edge, normal.cross(edge), normal;
        out[i].translation = origin + double(place.u) * e1 + double(place.v) * e2;
    }
    return out;
}

TriangleMesh posed_mesh(const TriangleMesh& rest, const ScalpPose& pose) {
    if (const auto* mesh = std::get_if<TriangleMesh>(&pose)) return *mesh;
    const RigidPose& rigid = std::get<RigidPose>(pose);
    TriangleMesh out = rest;
    for (Vec3f& p : out.positions) p = (rigid * p.cast<double>()).cast<float>();
    return out;
}

}  // namespace lancret
