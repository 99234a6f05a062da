#pragma once
// A scene without Embree: its curves and mesh at each time, and the properties of a hit.

#include <span>
#include <vector>

#include "guides/mesh/triangle_mesh.h"
#include "procedural/curves/curves.h"
#include "render_test/scene/hit.h"
#include "render_test/scene/smooth_normals.h"
#include "render_test/scene/strand_axis.h"

namespace lancret {

struct SceneShape {
    std::vector<const Curves*> curves;         ///< [times]
    TriangleMesh mesh;                         ///< at the first time
    std::vector<std::vector<Vec3f>> vertices;  ///< [times after the first]
    std::vector<CornerNormals> normals;        ///< [times], or empty: facets
    std::span<const float> true_radii;         ///< of HairSceneOptions
    float aspect = 1;                          ///< of HairSceneOptions

    std::size_t times() const { return curves.size(); }
    const std::vector<Vec3f>& vertices_at(std::size_t time) const {
        return time == 0 ? mesh.positions : vertices[time - 1];
    }
    /// The share of the drawn width that a strand truly covers.
    float opacity(std::uint32_t segment, float u, float drawn) const;
    /// The axis at `u` of a segment; `time` is a ray time, 0..1.
    AxisPoint axis(std::uint32_t segment, float u, float time) const;
    /// A strand's section as seen by a ray; `tangent` and `facing` are those of a hit.
    StrandSection section(std::uint32_t segment, float u, float time,
                          const Vec3f& tangent, const Vec3f& facing) const;
    /// Whether the position `v` of Embree, -1..1 across the drawn width, lies within the
    /// section of an elliptic strand.
    bool within_section(std::uint32_t segment, float u, float v, float time,
                        const Vec3f& direction) const;
    Vec3f vertex(std::uint32_t i, float time) const;
    /// The normal of a triangle's corner; not exactly unit between times.
    Vec3f corner_normal(std::uint32_t triangle, int corner, float time) const;

    /// Completes a hit that has its primitive, u, v, distance and position, and in
    /// `normal` the normal of Embree, of any length.
    void complete_strand(const Ray& ray, Hit& hit) const;
    void complete_mesh(const Ray& ray, Hit& hit) const;
};

}  // namespace lancret
