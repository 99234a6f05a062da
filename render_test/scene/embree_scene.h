#pragma once
// Strands and a mesh for ray tracing. Embree is used only in its source.

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
    /// Straight pieces per flat segment, 1..16. One is fastest and shows corners in
    /// close-ups of curls.
    int tessellation = 4;
    /// True radii, [points] of one time, cm: strands drawn wider than that let some rays
    /// pass (thin_strands.h). Empty: as drawn. Must outlive the scene.
    std::span<const float> true_radii = {};
    /// Meshes are smooth except at edges sharper than this, radian. 0 shows every facet.
    float crease = 0;
    /// Minor over major axis of a strand's section, (0, 1]; the radius is half the major
    /// axis, and the minor axis lies along the strand's face (Curves::normals). Below 1,
    /// strands must be flat B-splines.
    float aspect = 1;
    /// Number of segments, counted over all times, from which the BVH is Embree's compact
    /// one: half the memory (67 bytes per segment instead of 140), and rays a third
    /// slower.
    std::size_t compact_from = std::size_t(16) << 20;
    /// Called while the BVH is built with the completed share, 0 to 1: from any thread,
    /// one at a time.
    std::function<void(double)> progress = {};
};

/// The strands and the mesh at one time.
struct SceneTime {
    const Curves* curves = nullptr;      ///< required
    const TriangleMesh* mesh = nullptr;  ///< at all times or at none
};

/// Maximum number of times of a moving scene; a limit of Embree.
inline constexpr std::size_t kMaxSceneTimes = 129;

/// A scene that rays are traced in. Immutable, for any number of threads. Control points
/// are shared, not copied: `curves` must outlive the scene. The mesh is copied.
class HairScene {
  public:
    /// Builds on all threads. Throws std::invalid_argument if an index points outside its
    /// array or a UV is not finite, std::runtime_error if Embree fails.
    explicit HairScene(const Curves& curves, const TriangleMesh* mesh = nullptr,
                       const HairSceneOptions& options = {});
    /// A moving scene: `times` are evenly spaced from ray time 0 to 1, and control points
    /// and vertices are linear in between. One time is a static scene. Also throws
    /// std::invalid_argument if there is no time or more than kMaxSceneTimes, or if times
    /// differ in anything but positions, widths and UVs (those of the first are used).
    explicit HairScene(std::span<const SceneTime> times,
                       const HairSceneOptions& options = {});
    ~HairScene();
    HairScene(HairScene&&) noexcept;
    HairScene& operator=(HairScene&&) noexcept;

    std::optional<Hit> intersect(const Ray& ray) const;
    bool occluded(const Ray& ray) const;

    /// Whether strands may be drawn wider than their true radii.
    bool has_thin_strands() const;
    /// Whether there is more than one time.
    bool moves() const;
    /// Bounding box over all times, cm; empty for an empty scene.
    Eigen::AlignedBox3f bounds() const;
    /// Memory that Embree allocated for this scene, without the shared control points.
    std::size_t bvh_bytes() const;
    double build_seconds() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace lancret
