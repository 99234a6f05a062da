#pragma once
// The strands and the head of a picture, grown at each time of its shutter.

#include <optional>
#include <span>
#include <vector>

#include "render_test/plugin/strands.h"
#include "render_test/scene/camera.h"
#include "render_test/scene/embree_scene.h"
#include "tools/preview/picture.h"

namespace lancret {

/// The children and the head at one time.
struct ShownTime {
    double frame = 0;
    Curves curves;
    std::optional<TriangleMesh> body;
    std::vector<float> true_radii;  ///< if thin strands are drawn wider, else empty
};

/// How strands are drawn.
struct StrandDrawing {
    std::span<const Camera> cameras;  ///< of all pictures of these strands
    int height = 0;                   ///< of the pictures, pixels
    float min_width = 0;              ///< minimum width in any picture, pixels
    std::optional<CurveShape> shape;  ///< unset: round if a strand is wide in any picture
};

/// Grows the children at the `times` of a picture, one without motion blur. Throws
/// InputError.
std::vector<ShownTime> grow(const PluginGroom& groom, const PluginStrands& strands,
                            const std::vector<double>& times,
                            const StrandDrawing& drawing, PictureCost& cost);

/// The scene's view of `moments`, which must outlive it.
std::vector<SceneTime> scene_times(const std::vector<ShownTime>& moments);

/// Whether guides and head are at `times` exactly where they were when `moments` were
/// grown, so that these can be shown again. Throws InputError.
bool is_unchanged(const std::vector<ShownTime>& moments, const PluginGroom& groom,
                  const std::vector<double>& times);

}  // namespace lancret
