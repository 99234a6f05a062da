#include "guides/bodies/moving_bodies.h"

#include "guides/files/obj_file.h"

namespace lancret {

namespace {

struct MovingBody {
    int index;                                  ///< in Colliders
    std::shared_ptr<const ScalpMotion> motion;  ///< null: stands still
    bool deforms;                               ///< with the vertices of the scalp
};

TriangleMesh read_body(const std::filesystem::path& file, double scale) {
    TriangleMesh mesh = read_obj(file);
    for (Vec3f& p : mesh.positions) p *= float(scale);
    return mesh;
}

}  // namespace

MovingBodies moving_bodies(const HeadBody& head,
                           const std::vector<ColliderSettings>& settings,
                           double centimetres_per_unit, double frames_per_second) {
    MovingBodies out;
    std::vector<MovingBody> bodies;
    if (head.mesh) {
        bodies.push_back({out.colliders.add(*head.mesh), head.motion, head.deforms});
    }
    for (const ColliderSettings& collider : settings) {
        const int index = std::holds_alternative<Capsule>(collider.shape)
                              ? out.colliders.add(std::get<Capsule>(collider.shape))
                              : out.colliders.add(read_body(
                                    std::get<std::filesystem::path>(collider.shape),
                                    centimetres_per_unit));
        std::shared_ptr<const ScalpMotion> motion;
        if (collider.with_head) motion = head.motion;
        if (!collider.motion.keys.empty()) {
            motion = std::make_shared<const ScalpMotion>(
                scalp_motion(collider.motion, nullptr, frames_per_second));
        }
        bodies.push_back({index, motion, false});
    }
    const auto rest = std::make_shared<const TriangleMesh>(
        head.deforms && head.mesh ? *head.mesh : TriangleMesh{});
    out.move = [bodies, rest](double frame, Colliders& colliders) {
        for (const MovingBody& moving : bodies) {
            if (!moving.motion) continue;
            const ScalpTime time = scalp_at(*moving.motion, frame);
            if (moving.deforms) {
                colliders.move(moving.index, posed(time, *rest).positions);
            } else {
                colliders.move(moving.index, std::get<RigidMotion>(time).pose);
            }
        }
    };
    return out;
}

}  // namespace lancret
