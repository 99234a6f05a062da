#pragma once
// How the head moves in time, and hair's roots with it. Time is a frame number, with
// parts of frames; derivatives are per second.

#include <optional>
#include <variant>

#include "guides/motion/mesh_sequence.h"
#include "guides/motion/rigid_path.h"
#include "guides/motion/root_motion.h"

namespace lancret {

/// A head that moves as one piece (that stands still: one key), or deforms.
using ScalpMotion = std::variant<RigidPath, MeshSequence>;

/// A moving scalp at one time. Poses any number of roots, from any number of threads.
using ScalpTime = std::variant<RigidMotion, MeshMotion>;

/// The scalp at `frame` (finite). Throws what `rigid_motion` and `MeshSequence::at`
/// throw.
ScalpTime scalp_at(const ScalpMotion& motion, double frame);

/// A root at rest.
struct RestRoot {
    HelixState<double> pose;
    /// Where on the rest mesh. A rigid path does not ask.
    std::optional<MeshPoint> point;
};

/// How a root moves. On a rigid path its pose is the rigid image of the rest pose. On a
/// mesh sequence its position is the point of its triangle, and its frame turns with the
/// triangle's own (first edge, normal, and across): F(t) F_rest^T; rotation and its
/// derivatives are closed forms of the corners' motion. All of it in double.
///
/// Throws InputError, which names the triangle, where that has no area now or at rest,
/// and std::invalid_argument where a mesh sequence has no point to go by, or one that is
/// not of the mesh.
RootMotion root_motion(const ScalpTime& scalp, const RestRoot& root);

/// The rest mesh as it is then; rounded to float last. Throws std::invalid_argument where
/// a mesh sequence's rest mesh has not as many vertices.
TriangleMesh posed(const ScalpTime& scalp, TriangleMesh rest);

}  // namespace lancret
