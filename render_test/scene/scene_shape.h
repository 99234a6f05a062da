#pragma once
// What a scene is beside Embree: its curves and mesh at each time, and what there is to
// say of a place where a ray met them.

#include <span>
#include <vector>

#include "render_test/scene/embree_scene.h"
#include "render_test/scene/smooth_normals.h"
#include "render_test/scene/strand_axis.h"

namespace lancret {

struct SceneShape {
    std::vector<const Curves*> curves;         ///< [times]
    TriangleMesh mesh;                         ///< at the first time
    std::vector<std::vector<Vec3f>> vertices;  ///< [times after the first]
    std::vector<CornerNormals> normals;        ///< [times], or none: facets
    std::span<const float> true_radii;         ///< as HairSceneOptions'
    float aspect = 1;                          ///< as HairSceneOptions'

    std::size_t times() const { return curves.size(); }
    const std::vector<Vec3f>& vertices_at(std::size_t time) const {
        return time == 0 ? mesh.positions : vertices[time - 1];
    }
    /// The share of what is drawn there that a strand truly covers.
    float opacity(std::uint32_t segment, float u, float drawn) const;
    /// The axis at `u` of a segment; `time` is a ray's.
    AxisPoint axis(std::uint32_t segment, float u, float time) const;
    /// A strand's section as seen by a ray, where `tangent` and `facing` are a Hit's.
    StrandSection section(std::uint32_t segment, float u, float time,
                          const Vec3f& tangent, const Vec3f& facing) const;
    /// Whether an elliptic strand is there at Embree's `v` of its ribbon, -1..1.
    bool within_section(std::uint32_t segment, float u, float v, float time,
                        const Vec3f& direction) const;
    Vec3f vertex(std::uint32_t i, float time) const;
    /// Of a triangle's corner; not quite unit between times.
    Vec3f corner_normal(std::uint32_t triangle, int corner, float time) const;

    /// Fills in what follows from where the ray met something: `hit` has its primitive,
    /// u, v, distance and position, and in `normal` Embree's own, of any length.
    void complete_strand(const Ray& ray, Hit& hit) const;
    void complete_mesh(const Ray& ray, Hit& hit) const;
};

}  // namespace lancret
