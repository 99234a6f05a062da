#include "procedural/motion/posed_binding.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "guides/base/cancel.h"
#include "guides/base/coordinates.h"
#include "guides/base/errors.h"

namespace lancret {

namespace {

void pose_rigidly(Binding& binding, const RestPlaces& rest, const RigidPose& pose,
                  std::vector<Vec3>& out) {
    const auto turned = [&](const Vec3f& normal) -> Vec3f {
        return (pose.rotation * normal.cast<double>()).cast<float>();
    };
    Roots& roots = binding.roots;
    cancellable_for(std::size_t(0), rest.roots.size(), [&](std::size_t i) {
        roots.positions[i] = (pose * rest.roots[i].cast<double>()).cast<float>();
        roots.normals[i] = turned(rest.normals[i]);
    });
    std::ranges::transform(rest.guide_normals, binding.guide_normals.begin(), turned);
    for (const Vec3& root : rest.guide_roots) out.push_back(pose * root);
}

/// The scalp of a posed mesh, once it is seen to be the rest scalp's shape.
Scalp scalp_in_pose(const RestPlaces& rest, const TriangleMesh& mesh) {
    if (rest.triangles == 0) {
        throw InputError(
            "a posed scalp needs a scalp at rest, and the groom has none: name it in "
            "[scalp]");
    }
    if (mesh.positions.size() != rest.vertices ||
        mesh.triangles.size() != rest.triangles) {
        throw InputError(fmt::format(
            "the posed scalp has {} vertices and {} triangles, expected those of the "
            "rest scalp, {} and {}",
            mesh.positions.size(), mesh.triangles.size(), rest.vertices, rest.triangles));
    }
    if (!std::ranges::all_of(mesh.positions, is_place)) {
        throw InputError("the posed scalp has a vertex that is nowhere");
    }
    return make_scalp(mesh);
}

void pose_on_mesh(Binding& binding, const RestPlaces& rest, const Scalp& scalp,
                  std::vector<Vec3>& out) {
    Roots& roots = binding.roots;
    cancellable_for(std::size_t(0), rest.places.size(), [&](std::size_t i) {
        roots.positions[i] = scalp_position(scalp, rest.places[i]).cast<float>();
        roots.normals[i] = scalp_normal(scalp, rest.places[i]).cast<float>();
    });
    for (std::size_t g = 0; g < rest.guide_places.size(); ++g) {
        const MeshPoint& place = rest.guide_places[g];
        binding.guide_normals[g] = scalp_normal(scalp, place).cast<float>();
        out.push_back(scalp_position(scalp, place));
    }
}

}  // namespace

ScalpPose scalp_pose(const ScalpTime& scalp) {
    if (const auto* rigid = std::get_if<RigidMotion>(&scalp)) return rigid->pose;
    return posed(scalp, *std::get<MeshMotion>(scalp).rest);
}

RestPlaces rest_places(const Binding& binding, const PlacedGuides& source) {
    RestPlaces out;
    out.roots = binding.roots.positions;
    out.normals = binding.roots.normals;
    out.guide_normals = binding.guide_normals;
    out.guide_roots = source.guides.root_positions;
    if (source.scalp) {
        out.places = binding.roots.places;
        out.guide_places = source.places;
        out.vertices = source.scalp->mesh.positions.size();
        out.triangles = source.scalp->mesh.triangles.size();
    }
    return out;
}

std::vector<Vec3> pose_binding(Binding& binding, const RestPlaces& rest,
                               const ScalpPose& pose) {
    return pose_binding_on(binding, rest, posed_scalp(rest, pose));
}

PosedScalp posed_scalp(const RestPlaces& rest, const ScalpPose& pose) {
    if (const auto* rigid = std::get_if<RigidPose>(&pose)) return *rigid;
    return scalp_in_pose(rest, std::get<TriangleMesh>(pose));
}

std::vector<Vec3> pose_binding_on(Binding& binding, const RestPlaces& rest,
                                  const PosedScalp& scalp) {
    std::vector<Vec3> out;
    if (const auto* rigid = std::get_if<RigidPose>(&scalp)) {
        pose_rigidly(binding, rest, *rigid, out);
    } else {
        pose_on_mesh(binding, rest, std::get<Scalp>(scalp), out);
    }
    return out;
}

std::vector<RigidPose> carriers(const ScalpPose& pose, std::span<const MeshPoint> places,
                                std::size_t count) {
    if (const auto* rigid = std::get_if<RigidPose>(&pose)) return {count, *rigid};
    const TriangleMesh& mesh = std::get<TriangleMesh>(pose);
    if (places.size() != count) {
        throw InputError(
            "a posed scalp needs a scalp at rest, and the groom has none: name it in "
            "[scalp]");
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
            throw InputError(
                fmt::format("the posed scalp: triangle {} has no area, expected some "
                            "under each root",
                            place.triangle));
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
