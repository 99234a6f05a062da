#include "procedural/motion/posed_binding.h"

#include <fmt/format.h>

#include <algorithm>

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

/// The scalp of a posed mesh, after checking that it matches the rest scalp.
Scalp scalp_in_pose(const RestPlaces& rest, const TriangleMesh& mesh) {
    if (rest.triangles == 0) {
        throw InputError(
            "a posed scalp needs a scalp at rest, but the groom has none; set it in "
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
        throw InputError(fmt::format(
            "the posed scalp has a vertex that is not finite or beyond {:.0e} "
            "cm",
            kLargestCoordinate));
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

RestPlaces rest_places(const Binding& binding, const PlacedGuides& placed) {
    RestPlaces out;
    out.roots = binding.roots.positions;
    out.normals = binding.roots.normals;
    out.guide_normals = binding.guide_normals;
    out.guide_roots = placed.guides.root_positions;
    if (placed.scalp) {
        out.places = binding.roots.places;
        out.guide_places = placed.places;
        out.vertices = placed.scalp->mesh.positions.size();
        out.triangles = placed.scalp->mesh.triangles.size();
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

}  // namespace lancret
