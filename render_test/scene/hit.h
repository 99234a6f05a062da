#pragma once
// A ray, and the place where it first meets a strand or a mesh.

#include <cstdint>
#include <limits>

#include "guides/base/types.h"

namespace lancret {

struct Ray {
    Vec3f origin = Vec3f::Zero();      ///< cm
    Vec3f direction = Vec3f::UnitZ();  ///< unit
    float near = 0;                    ///< cm along the ray: hits before it do not count
    float far = std::numeric_limits<float>::infinity();  ///< cm
    float time = 0;  ///< 0..1, first to last time of a moving scene
    /// Whether a strand that is drawn wider than it is lets the ray by, by a chance that
    /// is a hash of ray and segment; else every one is a hit, with its opacity.
    bool by_chance = true;
};

/// Where a ray first meets something.
struct Hit {
    enum class Kind { strand, mesh };

    Kind kind = Kind::strand;
    std::uint32_t strand = 0;     ///< strands alone: its place among the curves
    std::uint32_t id = 0;         ///< strands alone: Curves::ids, the same in any subset
    std::uint32_t primitive = 0;  ///< segment of all strands, or triangle
    float u = 0;         ///< along the segment, 0..1; first barycentric of a mesh
    float v = 0;         ///< second barycentric of a mesh
    float distance = 0;  ///< cm
    Vec3f position = Vec3f::Zero();  ///< cm
    Vec3f normal = Vec3f::UnitZ();   ///< unit. A mesh: by its winding, towards either
                                     ///< side. Flat strands: across the tangent, to the
                                     ///< ray's origin. Round strands: outward. Ribbons:
                                     ///< across them, towards either side.
    Vec3f shading_normal = Vec3f::UnitZ();  ///< a mesh and ribbons: unit, smooth, on the
                                            ///< side of the ray's origin
    Vec3f lift = Vec3f::Zero();  ///< a mesh: cm, to where rays start (smooth_normals.h)
    Vec3f tangent =
        Vec3f::UnitX();  ///< unit, root to tip; of a mesh, along its first edge
    Vec3f facing = Vec3f::UnitZ();  ///< strands: unit, across the tangent and nearest to
                                    ///< the direction back along the ray
    Vec3f offset = Vec3f::Zero();   ///< strands: from the axis to the hit, across the
                                    ///< tangent, cm
    float radius = 0;               ///< strands: cm
    float h = 0;      ///< strands: offset . (facing x tangent) over half of the
                      ///< width that is seen, -1..1
    float along = 0;  ///< strands: 0 at the root to 1 at the tip
    float aspect = 1, section_angle = 0;  ///< strands: StrandSection's
    bool ribbon = false;       ///< strands: a surface, and no stand-in for a cylinder
    float opacity = 1;         ///< strands: true radius / drawn radius, where the ray is
                               ///< not by chance
    Vec2f uv = Vec2f::Zero();  ///< a mesh with UVs
};

/// A strand's section as the viewer sees it. Half axes are 1 and `aspect`, in radii.
struct StrandSection {
    float aspect = 1;  ///< minor over major, (0, 1]
    float angle = 0;   ///< radian, of the major axis from y towards z (HairBsdf's axes)

    /// Half of the width that the viewer sees, radii.
    float half_width() const;
};

}  // namespace lancret
