#pragma once
// Children at another time. Binding is computed at rest: guides, weights, lengths and
// faces stay the same. Only root positions and normals follow the scalp; they are
// overwritten in place, from their rest values.

#include <span>
#include <variant>
#include <vector>

#include "guides/motion/scalp_pose.h"
#include "procedural/groom/placed_guides.h"

namespace lancret {

/// The parts of a binding that follow the scalp, at rest.
struct RestPlaces {
    std::vector<Vec3f> roots, normals;        ///< [children], cm and unit
    std::vector<Vec3f> guide_normals;         ///< [guides]
    std::vector<Vec3> guide_roots;            ///< [guides], cm
    std::vector<MeshPoint> places;            ///< [children], empty without a scalp
    std::vector<MeshPoint> guide_places;      ///< [guides], empty without a scalp
    std::size_t vertices = 0, triangles = 0;  ///< of the scalp
};

/// The rest state of a binding that has not been posed yet. `placed` are its guides.
RestPlaces rest_places(const Binding& binding, const PlacedGuides& placed);

/// Moves the children's roots and normals and the guides' normals with the scalp, always
/// from rest, so errors do not accumulate. Expanding the binding with the profiles of the
/// guides at that time gives the children at that time. Returns the guides' root
/// positions on the posed scalp, [guides], cm. Throws InputError if a posed mesh has
/// other vertex or triangle counts than the rest scalp, a position that is not finite or
/// out of range, or no rest scalp.
std::vector<Vec3> pose_binding(Binding& binding, const RestPlaces& rest,
                               const ScalpPose& pose);

/// A pose of the scalp that was checked against the scalp at rest, for many bindings.
using PosedScalp = std::variant<RigidPose, Scalp>;

/// Throws the InputErrors of pose_binding.
PosedScalp posed_scalp(const RestPlaces& rest, const ScalpPose& pose);

/// pose_binding for a pose that was checked before.
std::vector<Vec3> pose_binding_on(Binding& binding, const RestPlaces& rest,
                                  const PosedScalp& scalp);

}  // namespace lancret
