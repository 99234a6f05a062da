#pragma once
// Bodies that hair collides with: moving spheres, capsules and triangle meshes.

#include <limits>
#include <span>
#include <variant>
#include <vector>

#include "guides/base/rigid_pose.h"
#include "guides/bodies/signed_distance.h"

namespace lancret {

/// All places within `radius` of the segment from a to b, in the body's space; a sphere
/// if a = b.
struct Capsule {
    Vec3 a = Vec3::Zero(), b = Vec3::Zero();  ///< cm
    double radius = 1;                        ///< cm, >= 0
};

/// The surface near a place, in world space.
struct SurfaceSample {
    /// cm, negative inside; +infinity if no surface is within reach.
    double distance = std::numeric_limits<double>::infinity();
    Vec3 normal = Vec3::UnitZ();  ///< unit, outward
    Vec3 point = Vec3::Zero();    ///< closest on the surface, cm
    int collider = -1;            ///< index of the body; -1: none
    std::uint32_t triangle = 0;   ///< of a mesh
};

/// Bodies at two times, the previous and the current one. Queries are deterministic, do
/// not allocate, and may come from several threads.
class Colliders {
  public:
    /// Adds a body that stands still at `pose` and returns its index. Throws
    /// std::invalid_argument if a number is not finite, a radius is below 0, the rotation
    /// is invalid, or SignedDistance rejects the mesh.
    int add(const Capsule& capsule, const RigidPose& pose = {});
    /// Places up to `depth` (cm, >= 0) behind a mesh with borders count as inside. Not
    /// used for a closed mesh.
    int add(const TriangleMesh& mesh, const RigidPose& pose = {}, double depth = 1);
    int size() const { return int(bodies_.size()); }
    /// The number of triangles of body `index`; 0 for a capsule.
    std::size_t triangles(int index) const;

    /// Sets the pose of body `index` at the new time; the current one becomes the
    /// previous. To be called once per step for each body: one that is not moved repeats
    /// its last movement, and stops when it is given the pose that it has. A mesh deforms
    /// to `positions` ([vertices], cm, in the body's space), which rebuilds its tree.
    /// Throws std::invalid_argument as `add` does, if there is no such body, or if the
    /// number of positions is wrong.
    void move(int index, const RigidPose& pose);
    void move(int index, std::span<const Vec3f> positions, const RigidPose& pose = {});

    /// The smallest signed distance from x (world, cm, finite) to a body; of equal ones
    /// that with the lowest index. Bodies farther away than `within` (cm, >= 0) are
    /// ignored. A closed body is found from any depth inside it; a mesh with borders has
    /// no inside and is found from behind down to `within` or its depth, whichever is
    /// larger. `share` in (0, 1] is the time: 1 is now, and at less the bodies are at
    /// that share of the way from the previous pose to the current one, except that a
    /// mesh that deforms has its current shape.
    SurfaceSample nearest(const Vec3& x, double within, double share = 1) const;

    /// Whether all bodies are closed: the distance then changes by at most as much as a
    /// place moves. Around the borders of other meshes it jumps.
    bool closed() const;

    /// The pose of body 0, to which `drift` is relative (identity without bodies).
    RigidPose reference() const {
        return bodies_.empty() ? RigidPose{} : bodies_[0].pose;
    }
    /// An upper limit of any surface's movement from the previous time to now, cm,
    /// relative to body 0, for callers that cache distances in its frame.
    double drift() const;

    /// The current position of the point that was at x (world, cm) at the previous time,
    /// if it sticks to the body of `sample` (whose collider is not -1): it keeps its
    /// position in the body's space, or, on a deformed mesh, its position relative to the
    /// plane of the sample's triangle. `from` and `to` are shares of the way, for times
    /// between.
    Vec3 carried(const SurfaceSample& sample, const Vec3& x, double from = 0,
                 double to = 1) const;

  private:
    /// A mesh, in the body's space, at both times.
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
