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
    /// Whether the ray may pass a strand that is drawn wider than it is, with a
    /// probability hashed from ray and segment; else every strand is a hit, with its
    /// opacity.
    bool by_chance = true;
};

/// A strand's section as the viewer sees it. Half axes are 1 and `aspect`, in radii.
struct StrandSection {
    float aspect = 1;  ///< minor over major, (0, 1]
    float angle = 0;   ///< radian, of the major axis from y towards z (HairBsdf's axes)

    /// Half of the width that the viewer sees, radii.
    float half_width() const;
};

/// The part of a hit that only strands have.
struct StrandHit {
    std::uint32_t index = 0;        ///< among the scene's curves
    std::uint32_t id = 0;           ///< Curves::ids, the same in any subset
    Vec3f facing = Vec3f::UnitZ();  ///< unit, across the tangent and nearest to the
                                    ///< direction back along the ray
    Vec3f offset = Vec3f::Zero();   ///< from the axis to the hit, across the tangent, cm
    float radius = 0;               ///< cm
    float h = 0;            ///< offset . (facing x tangent) over half of the visible
                            ///< width, -1..1
    float along = 0;        ///< 0 at the root to 1 at the tip
    float opacity = 1;      ///< true radius / drawn radius, unless the ray is by chance
    StrandSection section;  ///< as seen along the ray
    bool ribbon = false;    ///< a real surface, not a stand-in for a cylinder
};

/// The part of a hit that only the mesh has.
struct MeshHit {
    Vec3f lift = Vec3f::Zero();  ///< cm, to where new rays start (smooth_normals.h)
    Vec2f uv = Vec2f::Zero();    ///< if the mesh has UVs
};

/// Where a ray first meets something.
struct Hit {
    enum class Kind { strand, mesh };

    Kind kind = Kind::strand;
    std::uint32_t primitive = 0;  ///< segment, counted over all strands, or triangle
    float u = 0;                  ///< along the segment, 0..1; a mesh: first barycentric
    float v = 0;                  ///< a mesh: second barycentric
    float distance = 0;           ///< cm
    Vec3f position = Vec3f::Zero();  ///< cm
    /// Unit. A mesh: by its winding, towards either side. Flat strands: across the
    /// tangent, towards the ray's origin. Round strands: outward. Ribbons: across them,
    /// towards either side.
    Vec3f normal = Vec3f::UnitZ();
    Vec3f shading_normal = Vec3f::UnitZ();  ///< a mesh and ribbons: unit, smooth, on the
                                            ///< side of the ray's origin
    Vec3f tangent = Vec3f::UnitX();  ///< unit; a strand: root to tip; a mesh: along the
                                     ///< triangle's first edge
    StrandHit strand;                ///< defaults unless `kind` is strand
    MeshHit mesh;                    ///< defaults unless `kind` is mesh
};

}  // namespace lancret
