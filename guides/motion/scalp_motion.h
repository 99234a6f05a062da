#pragma once
// The motion of the head over time, and of the roots on it. Time is a frame number, not
// necessarily whole; derivatives are per second.

#include <optional>
#include <variant>

#include "guides/motion/mesh_sequence.h"
#include "guides/motion/rigid_path.h"
#include "guides/motion/root_motion.h"

namespace lancret {

/// A head that moves rigidly (with one key it stands still), or deforms.
using ScalpMotion = std::variant<RigidPath, MeshSequence>;

/// A moving scalp at one time. May be used from several threads.
using ScalpTime = std::variant<RigidMotion, MeshMotion>;

/// The scalp at `frame` (finite). Throws what `rigid_motion` and `MeshSequence::at`
/// throw.
ScalpTime scalp_at(const ScalpMotion& motion, double frame);

/// A root at rest.
struct RestRoot {
    HelixState<double> pose;
    /// Its place on the rest mesh. Not used with a rigid path.
    std::optional<MeshPoint> point;
};

/// The motion of a root. On a rigid path its pose is the rigid image of the rest pose. On
/// a mesh sequence its position is the point of its triangle, and its frame turns with
/// the frame F of the triangle (first edge, normal, and across): by F(t) F_rest^T. The
/// rotation and its derivatives are closed forms of the corners' motion, in double.
///
/// Throws InputError with the triangle if that has no area, now or at rest, and
/// std::invalid_argument if the root of a mesh sequence has no point on the mesh.
RootMotion root_motion(const ScalpTime& scalp, const RestRoot& root);

/// The mesh at that time, rounded to float at the end. Throws std::invalid_argument if
/// `rest` has not as many vertices as the rest mesh of the sequence.
TriangleMesh posed(const ScalpTime& scalp, TriangleMesh rest);

}  // namespace lancret
