#include "guides/bodies/collider_settings.h"

namespace lancret {

namespace {

enum class ColliderShape { sphere, capsule, mesh };
constexpr Named<ColliderShape> kColliderShapes[] = {{ColliderShape::sphere, "sphere"},
                                                    {ColliderShape::capsule, "capsule"},
                                                    {ColliderShape::mesh, "mesh"}};

ColliderSettings read_collider(const TomlTable& table) {
    ColliderSettings out;
    const auto shape = table.choice("shape", kColliderShapes);
    if (!shape) table.fail("", "a collider needs its 'shape'");
    if (*shape == ColliderShape::mesh) {
        const auto file = table.path("file");
        if (!file) table.fail("shape", "a mesh needs its 'file'");
        out.shape = *file;
    } else {
        const bool sphere = *shape == ColliderShape::sphere;
        Capsule body;
        assign_if(body.radius, table.number("radius", 1e-3, 1e4));
        assign_if(body.a, bounded_vector(table, sphere ? "centre" : "from"));
        body.b = body.a;
        if (!sphere) assign_if(body.b, bounded_vector(table, "to"));
        out.shape = body;
    }
    assign_if(out.with_head, table.boolean("with_head"));
    read_motion_keys(table, out.motion);
    if (out.with_head && !out.motion.keys.empty()) {
        table.fail("keys", "a collider moves with the head or by keys, not both");
    }
    return out;
}

}  // namespace

std::vector<ColliderSettings> read_colliders(const TomlTable& toml,
                                             const MotionSettings& head) {
    std::vector<ColliderSettings> out;
    for (const TomlTable& table : toml.tables("colliders")) {
        out.push_back(read_collider(table));
        if (out.back().with_head && head.deforms()) {
            table.fail("with_head",
                       "'with_head' needs a rigid head, and this one deforms; use "
                       "'keys'");
        }
    }
    return out;
}

}  // namespace lancret
