#pragma once
// What hair runs into: spheres, capsules and triangle meshes that move.

#include <limits>
#include <span>
#include <variant>
#include <vector>

#include "guides/base/rigid_pose.h"
#include "guides/bodies/signed_distance.h"

namespace lancret {

/// All places within `radius` of the segment from a to b, in the collider's own space; a
/// sphere where a = b.
struct Capsule {
    Vec3 a = Vec3::Zero(), b = Vec3::Zero();  ///< cm
    double radius = 1;                        ///< cm, >= 0
};

/// A surface near a place, in the world.
struct SurfaceSample {
    /// cm, negative inside; +infinity where no surface is within reach.
    double distance = std::numeric_limits<double>::infinity();
    Vec3 normal = Vec3::UnitZ();  ///< unit, outward
    Vec3 point = Vec3::Zero();    ///< closest on the surface, cm
    int collider = -1;            ///< -1 where there is none
    std::uint32_t triangle = 0;   ///< of a mesh
};

/// Bodies at two times, the previous and the current one. Queries are const, allocate
/// nothing, give the same each time and may come from many threads at once.
class Colliders {
  public:
    /// Adds a body that stands still at `pose`, and returns its index. Throws
    /// std::invalid_argument where a number is not finite, a radius is below 0, a
    /// rotation is none, or as SignedDistance does of a mesh.
    int add(const Capsule& capsule, const RigidPose& pose = {});
    /// `depth` (cm, >= 0) is how far behind a mesh with borders is still in it; a closed
    /// mesh does not ask.
    int add(const TriangleMesh& mesh, const RigidPose& pose = {}, double depth = 1);
    int size() const { return int(bodies_.size()); }
    /// Of body `index`; 0 of a capsule.
    std::size_t triangles(int index) const;

    /// Gives body `index` its place at the new time; what was current becomes the
    /// previous. Once a step for each: a body that is not moved goes on as in the step
    /// before, and the pose it has already is what stops it. A mesh deforms by
    /// `positions` ([vertices], cm, in its own space), for which its tree is built anew.
    /// Throws std::invalid_argument for what `add` would, where there is no such body, or
    /// where positions are too few or many.
    void move(int index, const RigidPose& pose);
    void move(int index, std::span<const Vec3f> positions, const RigidPose& pose = {});

    /// The smallest signed distance from x (world, cm, finite) of all bodies, now; of
    /// equal ones that of the lowest index. A body further off than `within` (cm, >= 0)
    /// counts as none. Inside of a closed body it is found at any depth; a mesh with
    /// borders has no inside, and what is behind it is found down to `within` or its
    /// depth, whichever is more.
    /// `share` in (0, 1] asks for a time between: bodies that turn and move are then that
    /// share of the way from the previous pose to the current one; a mesh that deforms
    /// has its current form.
    SurfaceSample nearest(const Vec3& x, double within, double share = 1) const;

    /// Whether the distance is that of closed bodies alone: nowhere does it change by
    /// more than a place moves. Round the borders of other meshes it jumps.
    bool closed() const;

    /// The pose of body 0, which others are told apart from (identity without bodies).
    RigidPose reference() const {
        return bodies_.empty() ? RigidPose{} : bodies_[0].pose;
    }
    /// No surface moved by more than this, cm, from the previous time to now, as seen
    /// from body 0: for who remembers distances in its space.
    double drift() const;

    /// Where the point that was at x (world, cm) at the previous time is now, if it
    /// sticks to the body of `sample` (of whose collider is not -1): it keeps its place
    /// in the body's own space, on a deformed mesh its place in the plane of the sample's
    /// triangle and its height over it.
    /// `from` and `to` are shares of the way, for times between.
    Vec3 carried(const SurfaceSample& sample, const Vec3& x, double from = 0,
                 double to = 1) const;

  private:
    /// A mesh in its own space at both times.
    struct MeshBody {
        TriangleMesh mesh;
        std::vector<Vec3f> previous;  ///< [vertices], cm
        SignedDistance distance;
        Eigen::AlignedBox3d box;
        double depth = 0;       ///< cm
        bool deformed = false;  ///< between the previous time and now
    };
    struct Body {
        std::variant<Capsule, MeshBody> shape;
        RigidPose pose, previous;
    };
    static RigidPose pose_at(const Body& body, double share);
    static SurfaceSample near(const Body& body, const Vec3& place, double within,
                              double best);
    std::vector<Body> bodies_;
};

}  // namespace lancret
