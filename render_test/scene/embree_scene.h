#pragma once
// Strands and a mesh as rays see them: the only file that knows Embree.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "guides/mesh/triangle_mesh.h"
#include "procedural/curves/curves.h"
#include "render_test/scene/hit.h"

namespace lancret {

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
