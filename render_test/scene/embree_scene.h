#pragma once
// Strands and a mesh as rays see them: the only file that knows Embree.

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "guides/base/types.h"
#include "guides/mesh/triangle_mesh.h"
#include "procedural/curves/curves.h"

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

struct HairSceneOptions {
    /// Pieces that a flat segment is cut into, 1..16. One is fastest and shows corners in
    /// a close-up of curls.
    int tessellation = 4;
    /// [points of a time's curves], cm: strands drawn wider than they are let rays by
    /// (thin_strands.h). Empty: they are as drawn. Must outlive the scene.
    std::span<const float> true_radii = {};
    /// Radian: meshes are smooth but for edges that are sharper. 0 shows every facet.
    float crease = 0;
    /// Minor over major axis of a strand's section, above 0 to 1; the radius is half the
    /// major axis, and the minor one lies along the strand's face (Curves::normals).
    /// Below 1 strands must be flat B-splines.
    float aspect = 1;
    /// From this many segments on, those of all times counted, the BVH is Embree's
    /// compact one: half the memory (67 bytes a segment of 140), and rays a third slower.
    std::size_t compact_from = std::size_t(16) << 20;
    /// Called as the BVH is built with the share that is done, 0 to 1: from any thread,
    /// one at a time.
    std::function<void(double)> progress = {};
};

/// What there is at one time.
struct SceneTime {
    const Curves* curves = nullptr;      ///< required
    const TriangleMesh* mesh = nullptr;  ///< at all times or at none
};

/// The most times of a moving scene; Embree's own limit.
inline constexpr std::size_t kMaxSceneTimes = 129;

/// Built once, then read by any number of threads. The control points are shared, not
/// copied: `curves` must outlive the scene. The mesh is copied.
class HairScene {
  public:
    /// Builds on all threads. Throws std::invalid_argument where an index points outside
    /// its array or a UV is not finite, std::runtime_error where Embree fails.
    explicit HairScene(const Curves& curves, const TriangleMesh* mesh = nullptr,
                       const HairSceneOptions& options = {});
    /// A scene that moves: `times` are evenly spread from ray time 0 to 1, and control
    /// points and vertices are linear between them. One time is a scene that stands
    /// still. Throws also where there is no time or more than kMaxSceneTimes, or where
    /// times differ in anything but places, widths and UVs (those of the first count).
    explicit HairScene(std::span<const SceneTime> times,
                       const HairSceneOptions& options = {});
    ~HairScene();
    HairScene(HairScene&&) noexcept;
    HairScene& operator=(HairScene&&) noexcept;

    std::optional<Hit> intersect(const Ray& ray) const;
    bool occluded(const Ray& ray) const;

    /// Whether strands may be drawn wider than they are.
    bool has_thin_strands() const;
    /// Whether there is more than one time.
    bool moves() const;
    /// Box around everything at all times, cm; empty if there is nothing.
    Eigen::AlignedBox3f bounds() const;
    /// What Embree holds for this scene, without the shared control points.
    std::size_t bvh_bytes() const;
    double build_seconds() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace lancret
