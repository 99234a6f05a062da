#include "guides/bodies/colliders.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "guides/base/coordinates.h"
#include "guides/helix/helix.h"

namespace lancret {

namespace {

void check(const RigidPose& pose) {
    const Mat3& r = pose.rotation;
    // Written so that a NaN fails. 1e-6 accepts float rotations.
    if (!((r.transpose() * r - Mat3::Identity()).cwiseAbs().maxCoeff() < 1e-6 &&
          r.determinant() > 0 && pose.translation.allFinite())) {
        throw std::invalid_argument(
            "Colliders: expected a rotation and a finite translation");
    }
}

Eigen::AlignedBox3d box_of(const std::vector<Vec3f>& positions) {
    Eigen::AlignedBox3d box;
    for (const Vec3f& p : positions) box.extend(p.cast<double>());
    return box;
}

SurfaceSample near_capsule(const Capsule& capsule, const Vec3& place) {
    const Vec3 axis = capsule.b - capsule.a;
    const double length2 = axis.squaredNorm();
    const double t =
        length2 > 0 ? std::clamp((place - capsule.a).dot(axis) / length2, 0.0, 1.0) : 0.0;
    const Vec3 centre = capsule.a + t * axis, away = place - centre;
    const double height = away.norm();
    SurfaceSample out;
    // On the axis every direction across it is as short.
    out.normal = height > 0    ? Vec3(away / height)
                 : length2 > 0 ? Vec3(axis.unitOrthogonal())
                               : Vec3(Vec3::UnitZ());
    out.distance = height - capsule.radius;
    out.point = centre + capsule.radius * out.normal;
    return out;
}

/// A triangle's corner, edges and unit normal.
struct Plane {
    Vec3 corner, e1, e2, normal;
};

Plane plane_of(const std::vector<Vec3f>& positions,
               const std::array<std::uint32_t, 3>& triangle) {
    const Vec3 p = positions[triangle[0]].cast<double>();
    const Vec3 e1 = positions[triangle[1]].cast<double>() - p;
    const Vec3 e2 = positions[triangle[2]].cast<double>() - p;
    // stableNormalized keeps a zero vector zero.
    return {p, e1, e2, e1.cross(e2).stableNormalized()};
}

/// x with its position in the plane and its height above it kept from plane to plane.
Vec3 carried_by(const Plane& from, const Plane& to, const Vec3& x) {
    const Vec3 d = x - from.corner;
    const double a = from.e1.squaredNorm(), b = from.e1.dot(from.e2),
                 c = from.e2.squaredNorm(), det = a * c - b * b;
    // A triangle without area has no plane: x follows its corner.
    if (!(det > 1e-12 * a * c)) return to.corner + d;
    const double f = from.e1.dot(d), g = from.e2.dot(d);
    const double u = (f * c - g * b) / det, v = (g * a - f * b) / det;
    return to.corner + u * to.e1 + v * to.e2 + from.normal.dot(d) * to.normal;
}

}  // namespace

int Colliders::add(const Capsule& capsule, const RigidPose& pose) {
    check(pose);
    if (!(capsule.radius >= 0 && std::isfinite(capsule.radius) && capsule.a.allFinite() &&
          capsule.b.allFinite())) {
        throw std::invalid_argument(
            "Colliders: expected a finite capsule with a radius of at least 0");
    }
    bodies_.push_back({capsule, pose, pose});
    return size() - 1;
}

int Colliders::add(const TriangleMesh& mesh, const RigidPose& pose, double depth) {
    check(pose);
    if (!(depth >= 0 && std::isfinite(depth))) {
        throw std::invalid_argument("Colliders: the depth must be at least 0");
    }
    bodies_.push_back({MeshBody{mesh, mesh.positions, SignedDistance(mesh),
                                box_of(mesh.positions), depth},
                       pose, pose});
    return size() - 1;
}

void Colliders::move(int index, const RigidPose& pose) {
    check(pose);
    if (index < 0 || index >= size()) {
        throw std::invalid_argument("Colliders: no such body");
    }
    Body& body = bodies_[std::size_t(index)];
    body.previous = std::exchange(body.pose, pose);
    if (auto* mesh = std::get_if<MeshBody>(&body.shape); mesh && mesh->deformed) {
        mesh->previous = mesh->mesh.positions;
        mesh->deformed = false;
    }
}

void Colliders::move(int index, std::span<const Vec3f> positions, const RigidPose& pose) {
    check(pose);
    auto* mesh = index < 0 || index >= size()
                     ? nullptr
                     : std::get_if<MeshBody>(&bodies_[std::size_t(index)].shape);
    if (!mesh || mesh->mesh.positions.size() != positions.size()) {
        throw std::invalid_argument(
            "Colliders: the body is not a mesh with this number of vertices");
    }
    // The new tree first: if it throws, nothing has changed.
    TriangleMesh moved{{positions.begin(), positions.end()}, mesh->mesh.triangles, {}};
    mesh->distance = SignedDistance(moved);
    mesh->previous = std::move(mesh->mesh.positions);
    mesh->mesh = std::move(moved);
    mesh->box = box_of(mesh->mesh.positions);
    mesh->deformed = true;
    Body& body = bodies_[std::size_t(index)];
    body.previous = std::exchange(body.pose, pose);
}

RigidPose Colliders::pose_at(const Body& body, double share) {
    if (share >= 1) return body.pose;
    const RigidPose &a = body.previous, &b = body.pose;
    const Vec3 turn = rotation_log<double>(b.rotation * a.rotation.transpose());
    RigidPose out{helix_step<double>(turn, share).rotation * a.rotation,
                  a.translation + share * (b.translation - a.translation)};
    orthonormalize<double>(out.rotation);
    return out;
}

bool Colliders::closed() const {
    return std::ranges::all_of(bodies_, [](const Body& body) {
        const auto* mesh = std::get_if<MeshBody>(&body.shape);
        return !mesh || mesh->distance.closed();
    });
}

SurfaceSample Colliders::near(const Body& body, const Vec3& place, double within,
                              double best) {
    if (const auto* capsule = std::get_if<Capsule>(&body.shape)) {
        return near_capsule(*capsule, place);
    }
    const auto& mesh = std::get<MeshBody>(body.shape);
    // Outside its box a closed mesh has a positive distance, which matters only below the
    // best so far; inside, the distance may be negative and of any size. A place behind a
    // mesh with borders may be anywhere.
    const bool closed = mesh.distance.closed();
    const double reach =
        closed ? std::max(0.0, std::min(within, best)) : std::max(within, mesh.depth);
    const double outside = mesh.box.exteriorDistance(place);
    if (outside > reach) return {};
    const double search =
        closed && outside == 0 ? std::numeric_limits<double>::infinity() : reach;
    const MeshDistance found = mesh.distance.at(place, search);
    return {found.distance, found.normal, found.point, -1, found.triangle};
}

SurfaceSample Colliders::nearest(const Vec3& x, double within, double share) const {
    SurfaceSample best;
    RigidPose of_best;
    for (int i = 0; i < size(); ++i) {
        const Body& body = bodies_[std::size_t(i)];
        const RigidPose pose = pose_at(body, share);
        const SurfaceSample found =
            near(body, inverse_image(pose, x), within, best.distance);
        if (!(found.distance <= within && found.distance < best.distance)) continue;
        best = found;
        best.collider = i;
        of_best = pose;
    }
    if (best.collider >= 0) {
        best.normal = of_best.rotation * best.normal;
        best.point = of_best * best.point;
    }
    return best;
}

std::size_t Colliders::triangles(int index) const {
    const auto* mesh = std::get_if<MeshBody>(&bodies_[std::size_t(index)].shape);
    return mesh ? mesh->mesh.triangles.size() : 0;
}

Vec3 Colliders::carried(const SurfaceSample& sample, const Vec3& x, double from,
                        double to) const {
    const Body& body = bodies_[std::size_t(sample.collider)];
    Vec3 place = inverse_image(from > 0 ? pose_at(body, from) : body.previous, x);
    // A mesh has its current shape throughout the step, except at its beginning.
    const auto* mesh = std::get_if<MeshBody>(&body.shape);
    if (mesh && mesh->deformed && from == 0) {
        const auto& triangle = mesh->mesh.triangles[sample.triangle];
        place = carried_by(plane_of(mesh->previous, triangle),
                           plane_of(mesh->mesh.positions, triangle), place);
    }
    return pose_at(body, to) * place;
}

double Colliders::drift() const {
    double square = 0;
    const auto moves = [&](const Vec3& before, const Vec3& now) {
        square = std::max(square, (now - before).squaredNorm());
    };
    for (const Body& body : bodies_) {
        const Body& first = bodies_.front();
        const auto seen = [&](const RigidPose& own, const RigidPose& from,
                              const Vec3& x) { return inverse_image(from, own * x); };
        const auto* mesh = std::get_if<MeshBody>(&body.shape);
        if (mesh && mesh->deformed) {
            for (std::size_t i = 0; i < mesh->previous.size(); ++i) {
                moves(
                    seen(body.previous, first.previous, mesh->previous[i].cast<double>()),
                    seen(body.pose, first.pose, mesh->mesh.positions[i].cast<double>()));
            }
            continue;
        }
        // The point of a box that an affine map moves farthest is a corner.
        Eigen::AlignedBox3d box;
        if (mesh) {
            box = mesh->box;
        } else {
            const Capsule& capsule = std::get<Capsule>(body.shape);
            const Vec3 reach = Vec3::Constant(capsule.radius);
            for (const Vec3& end : {capsule.a, capsule.b}) {
                box.extend(Vec3(end - reach));
                box.extend(Vec3(end + reach));
            }
        }
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 x = box.corner(Eigen::AlignedBox3d::CornerType(corner));
            moves(seen(body.previous, first.previous, x), seen(body.pose, first.pose, x));
        }
    }
    return std::sqrt(square);
}

}  // namespace lancret
