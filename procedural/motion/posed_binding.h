#pragma once
// Children at another time. What binding decides (guides, weights, lengths, faces) is
// decided at rest and stays; only where roots stand and which way their normals point
// follows the scalp. Those few numbers are written in place, from their rest values.

#include <span>
#include <variant>
#include <vector>

#include "guides/motion/scalp_pose.h"
#include "procedural/groom/placed_guides.h"

namespace lancret {

/// What follows the scalp, at rest.
struct RestPlaces {
    std::vector<Vec3f> roots, normals;        ///< [children], cm and unit
    std::vector<Vec3f> guide_normals;         ///< [guides]
    std::vector<Vec3> guide_roots;            ///< [guides], cm
    std::vector<MeshPoint> places;            ///< [children], empty without a scalp
    std::vector<MeshPoint> guide_places;      ///< [guides], empty without a scalp
    std::size_t vertices = 0, triangles = 0;  ///< of the scalp
};

/// Of a binding that `pose_binding` has not touched yet, and the guides it was made with.
RestPlaces rest_places(const Binding& binding, const PlacedGuides& placed);

/// Puts the children's roots and normals and the guides' normals where the scalp has
/// them, each time from rest, so that nothing adds up. Expanding the binding with the
/// guides' profiles of that time gives the children of that time. Returns where the scalp
/// has the guides' roots, [guides], cm. Throws InputError where a posed mesh has not as
/// many vertices and triangles as the rest scalp, where there is no rest scalp for it, or
/// where it is nowhere finite.
std::vector<Vec3> pose_binding(Binding& binding, const RestPlaces& rest,
                               const ScalpPose& pose);

/// A pose of the scalp that was held against the scalp at rest, for many bindings.
using PosedScalp = std::variant<RigidPose, Scalp>;

/// Throws as pose_binding does.
PosedScalp posed_scalp(const RestPlaces& rest, const ScalpPose& pose);

/// pose_binding, for a pose that was looked at before.
std::vector<Vec3> pose_binding_on(Binding& binding, const RestPlaces& rest,
                                  const PosedScalp& scalp);

}  // namespace lancret
