#pragma once
// A picture from a scene and a camera.

#include <cstdint>
#include <functional>

#include "render_test/image/image.h"
#include "render_test/scene/camera.h"
#include "render_test/trace/film.h"
#include "render_test/trace/path_tracer.h"

namespace lancret {

/// A sensible most for a noise to reach.
inline constexpr int kMaxAdaptiveSamples = 1024;

struct RenderSettings {
    int width = 640, height = 640;  ///< pixels
    int samples = 64;               ///< paths a pixel, spread evenly over its square
    /// Relative noise at which a pixel has samples enough (adaptive.h), `samples` being
    /// the most of any; 0: all have `samples`.
    float noise = 0;
    std::uint64_t seed = 0;
    PathSettings path;
    Channels channels;  ///< kept beside colour, depth, normal, tangent and id
};

struct RenderProgress {
    double done = 0;          ///< share, 0..1
    std::uint64_t rays = 0;   ///< traced so far, shadow rays too
    std::uint64_t paths = 0;  ///< followed so far: samples of all pixels
};
using ProgressFunction = std::function<void(const RenderProgress&)>;

/// Renders on all threads; the same bits for any number of them. `progress`, where given,
/// is called from any thread but one at a time. Throws std::invalid_argument where a
/// setting is out of its range, std::runtime_error where a pixel is not a finite number.
Image render(const RenderScene& scene, const Camera& camera,
             const RenderSettings& settings, const ProgressFunction& progress = {});

/// The same picture, bit for bit, shown on its way there: `show` gets the picture of one
/// sample a pixel, then of 2, 4, 8 and so on (some pixels of fewer, where there is a
/// noise to reach), and the last of all.
void render_progressively(const RenderScene& scene, const Camera& camera,
                          const RenderSettings& settings,
                          const std::function<void(const Image&, int samples)>& show,
                          const ProgressFunction& progress = {});

}  // namespace lancret
